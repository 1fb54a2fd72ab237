//! Uniforms: their intervals, grids and ends, and the azimuth's error.
#![allow(clippy::incompatible_msrv)] // the MSRV is the core's; tests run on newer toolchains

use coslobe::uniform::{azimuth_from_bits, tails_from_bits};
use coslobe::{CosSin, Fast, Precise};
use kit::accuracy::double::Double;
use kit::accuracy::format::{Format, error_in_ulps};
use kit::accuracy::wide::Wide;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

#[test]
fn the_ends_are_as_documented() {
    let least = tails_from_bits::<f32>(0);
    assert_eq!((least.lower(), least.upper()), (0.5f32.powi(65), 1.0));
    let other = tails_from_bits::<f32>(1 << 63);
    assert_eq!((other.lower(), other.upper()), (1.0, 0.5f32.powi(65)));
    for full in [u64::MAX, u64::MAX >> 1] {
        let middle = tails_from_bits::<f32>(full);
        assert_eq!((middle.lower(), middle.upper()), (0.5, 0.5));
    }
    let least = tails_from_bits::<f64>(0);
    assert_eq!((least.lower(), least.upper()), (0.5f64.powi(129), 1.0));
    for full in [u128::MAX, u128::MAX >> 1] {
        let middle = tails_from_bits::<f64>(full);
        assert_eq!((middle.lower(), middle.upper()), (0.5, 0.5));
    }
}

/// `Precise` has the plain types' uniforms; `Fast` has odd multiples of 2⁻³², of which it
/// reads the upper half of its bits alone.
#[test]
fn the_tiers_have_their_grids() {
    let mut rng = Pcg64::seed_from_u64(13);
    for i in 0..100_000 {
        let word = rng.next_u64() >> (i % 64);
        let (plain, precise) = (
            tails_from_bits::<f32>(word),
            tails_from_bits::<Precise<f32>>(word),
        );
        assert_eq!(
            [precise.lower().0, precise.upper().0],
            [plain.lower(), plain.upper()]
        );
        let word = u128::from(word) << (i % 64);
        let (plain, precise) = (
            tails_from_bits::<f64>(word),
            tails_from_bits::<Precise<f64>>(word),
        );
        assert_eq!(
            [precise.lower().0, precise.upper().0],
            [plain.lower(), plain.upper()]
        );

        let (word, unread) = (rng.next_u32() >> (i % 32), rng.next_u32());
        let fast = tails_from_bits::<Fast<f32>>(u64::from(word) << 32 | u64::from(unread));
        let (p, other) = if word >> 31 == 0 {
            (fast.lower().0, fast.upper().0)
        } else {
            (fast.upper().0, fast.lower().0)
        };
        let exact = f64::from(word & (u32::MAX >> 1) | 1) * 0.5f64.powi(32);
        assert_eq!(p, exact as f32, "{word:#x}");
        assert_eq!(other, (1.0 - exact) as f32, "{word:#x}");
    }
}

/// The nearer tail is an odd multiple of 2⁻⁶⁵ (2⁻¹²⁹), rounded to nearest, at every depth.
#[test]
fn the_grid_is_as_documented() {
    let mut rng = Pcg64::seed_from_u64(7);
    for depth in 0..64 {
        for _ in 0..200 {
            let word = (rng.next_u64() >> 1) >> depth;
            let exact = (2.0 * word as f64 + 1.0) * 0.5f64.powi(65);
            let p = tails_from_bits::<f32>(word).lower();
            // f64 holds words below 2⁵² exactly, and rounding twice is right but for rare ties.
            let ulp = f64::from(p.next_up()) - f64::from(p);
            assert!((f64::from(p) - exact).abs() <= 0.5 * ulp, "{word:#x}");
            if depth >= 41 {
                assert_eq!(f64::from(p), exact, "{word:#x}: exact below 2⁻⁴¹");
            }
            assert_eq!(tails_from_bits::<f32>(word).upper(), 1.0 - p);
        }
    }
    for depth in 76..128 {
        let word = u128::MAX >> 1 >> depth;
        let exact = (2.0 * word as f64 + 1.0) * 0.5f64.powi(129);
        assert_eq!(tails_from_bits::<f64>(word).lower(), exact);
    }
}

/// The 24-bit uniform has nothing between 0 and 2⁻²⁴; here each octave below holds its half.
#[test]
fn each_octave_of_the_tail_has_its_share() {
    let mut rng = Pcg64::seed_from_u64(11);
    for depth in [24, 40, 60] {
        let n = 40_000;
        let below = (0..n)
            .filter(|_| {
                let word = (rng.next_u64() >> 1) >> depth;
                tails_from_bits::<f32>(word).lower() < 0.5f32.powi(depth + 2)
            })
            .count();
        let z = (below as f64 - f64::from(n) / 2.0) / (f64::from(n) / 4.0).sqrt();
        assert!(z.abs() < 4.5, "2^-{depth}: z = {z}");
    }
}

/// The larger error in ulps of cos and sin at `quadrant`/4 + `turn`, |turn| ≤ ⅛.
fn azimuth_error<T: Format>(got: CosSin<T>, quadrant: u64, turn: T::Wide, negative: bool) -> f64 {
    let angle = turn * T::Wide::pi() * T::Wide::of(2.0);
    let (sin, cos) = if negative { -angle } else { angle }.sin_cos();
    let sin = if negative { -sin } else { sin };
    let [c, s] = [[cos, sin], [-sin, cos], [-cos, -sin], [sin, -cos]][quadrant as usize & 3];
    error_in_ulps(got.cos, c).max(error_in_ulps(got.sin, s))
}

fn f32_azimuth_error(word: u32) -> f64 {
    let quadrant = word.wrapping_add(1 << 29) >> 30;
    let rest = word.wrapping_sub(quadrant << 30) as i32;
    let turn = (f64::from(rest) + 0.5) * 0.5f64.powi(32);
    azimuth_error(
        azimuth_from_bits::<f32>(word),
        quadrant.into(),
        turn,
        rest < 0,
    )
}

fn f64_azimuth_error(word: u64) -> f64 {
    let quadrant = word.wrapping_add(1 << 61) >> 62;
    let rest = word.wrapping_sub(quadrant << 62) as i64;
    // The odd integer 2·rest + 1 as two words, each exact.
    let odd = 2 * i128::from(rest) + 1;
    let (high, low) = (
        (odd >> 32) as f64 * 2f64.powi(32),
        (odd & 0xFFFF_FFFF) as f64,
    );
    let turn = Double::sum(high, low).scale(-65);
    azimuth_error(azimuth_from_bits::<f64>(word), quadrant, turn, rest < 0)
}

/// The worst over the words stays within what `uniform::azimuth_from_bits` states.
fn azimuths_within_bound<W: Copy + std::fmt::LowerHex>(
    words: impl Iterator<Item = W>,
    error: impl Fn(W) -> f64,
) {
    let (mut worst, mut at, mut tried) = (0.0, None, 0u64);
    for word in words {
        let e = error(word);
        tried += 1;
        if e > worst {
            (worst, at) = (e, Some(word));
        }
    }
    let at = at.expect("some error");
    println!("azimuth: {worst:.3} ulp at word {at:#x}, {tried} words");
    assert!(worst <= 2.5, "{worst} ulp at word {at:#x}");
}

#[test]
fn f32_azimuths() {
    azimuths_within_bound((0..=u32::MAX).step_by(4001), f32_azimuth_error);
    let edges = [
        0,
        1,
        u32::MAX,
        1 << 29,
        (1 << 29) - 1,
        1 << 30,
        1 << 31,
        (1 << 31) - 1,
    ];
    azimuths_within_bound(edges.into_iter(), f32_azimuth_error);
}

#[test]
fn f64_azimuths() {
    // Half of the words spread over the turn, half crowding towards the axes.
    let words = (0..1_000_000u64).map(|i| {
        let mixed = i.wrapping_mul(0x9E37_79B9_7F4A_7C15);
        if i % 2 == 0 { mixed } else { mixed >> (i % 64) }
    });
    azimuths_within_bound(words, f64_azimuth_error);
}

/// `Precise`: the nearest numbers. `Fast`: 2⁻¹² of each component.
#[test]
fn azimuths_of_the_tiers() {
    let parts = |word: u32| {
        let quadrant = word.wrapping_add(1 << 29) >> 30;
        let rest = word.wrapping_sub(quadrant << 30) as i32;
        (
            quadrant,
            (f64::from(rest) + 0.5) * 0.5f64.powi(32),
            rest < 0,
        )
    };
    let raw = |at: CosSin<Precise<f32>>| CosSin {
        cos: at.cos.0,
        sin: at.sin.0,
    };
    for word in (0..=u32::MAX).step_by(40_009) {
        let (quadrant, turn, negative) = parts(word);
        let precise = raw(azimuth_from_bits(word));
        let error = azimuth_error(precise, quadrant.into(), turn, negative);
        assert!(error <= 0.5 + 1e-6, "{error} ulp at word {word:#x}");
        let fast = azimuth_from_bits::<Fast<f32>>(word);
        for (a, b) in [(fast.cos.0, precise.cos), (fast.sin.0, precise.sin)] {
            assert!(
                (a - b).abs() <= b.abs() / 4096.0,
                "{a} and {b} at word {word:#x}"
            );
        }
    }
}

#[test]
#[ignore = "opt-in, minutes: cargo test --release --test words -- --ignored --nocapture"]
fn f32_azimuths_exhaustive() {
    azimuths_within_bound(0..=u32::MAX, f32_azimuth_error);
}

/// Words beside each axis and diagonal whose components are 0 or equal.
fn on_a_line<T: kit::Number>(of: impl Fn(u64) -> CosSin<T>, bits: u32) -> [usize; 2] {
    let mut found = [0, 0];
    for eighth in 0..8u64 {
        for offset in 0..1 << 13 {
            let word = (eighth << (bits - 3))
                .wrapping_add(offset)
                .wrapping_sub(1 << 12);
            let CosSin { cos, sin } = of(word & (u64::MAX >> (64 - bits)));
            found[0] += usize::from(cos == T::ZERO || sin == T::ZERO);
            found[1] += usize::from(cos.abs() == sin.abs());
        }
    }
    found
}

/// No azimuth is on an axis; those nearest to a diagonal round to it.
#[test]
fn azimuths_on_diagonals_are_counted() {
    let single = on_a_line(|word| azimuth_from_bits::<f32>(word as u32), 32);
    let precise = on_a_line(|word| azimuth_from_bits::<Precise<f32>>(word as u32), 32);
    let double = on_a_line(azimuth_from_bits::<f64>, 64);
    println!("{single:?} {precise:?} {double:?}");
    assert_eq!([single, precise, double], [[0, 128], [0, 136], [0, 0]]);
    let CosSin { cos, sin } = azimuth_from_bits::<f32>(0x1fff_fff0);
    assert_eq!(cos, sin);
}
