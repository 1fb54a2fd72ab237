//! Uniforms: their intervals, grids and ends, and the azimuth's error.
#![allow(clippy::incompatible_msrv)] // the MSRV is the core's; tests run on newer toolchains

use coslobe::uniform::{azimuth_from_bits, tails_from_bits};
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
        assert!(depth == 60 || z.abs() < 4.5, "2^-{depth}: z = {z}");
    }
}

/// Relative error in ulps of the exact value, which the folded angle in f64 gives.
fn azimuth_error(word: u32) -> f64 {
    let at = azimuth_from_bits::<f32>(word);
    let quadrant = word.wrapping_add(1 << 29) >> 30;
    let rest = word.wrapping_sub(quadrant << 30) as i32;
    let angle = (f64::from(rest) + 0.5) * 0.5f64.powi(32) * std::f64::consts::TAU;
    let (s, c) = angle.sin_cos();
    let (cos, sin) = [(c, s), (-s, c), (-c, -s), (s, -c)][quadrant as usize & 3];
    let error = |got: f32, want: f64| {
        let ulp = f64::from((want.abs() as f32).next_up()) - f64::from(want.abs() as f32);
        (f64::from(got) - want).abs() / ulp
    };
    error(at.cos, cos).max(error(at.sin, sin))
}

fn azimuths_within_bound(stride: usize) {
    let (mut worst, mut at) = (0.0, 0);
    for word in (0..=u32::MAX).step_by(stride) {
        let error = azimuth_error(word);
        if error > worst {
            (worst, at) = (error, word);
        }
    }
    println!("azimuth f32: {worst:.3} ulp at word {at:#x}, stride {stride}");
    assert!(worst <= 2.5, "{worst} ulp at word {at:#x}");
}

#[test]
fn azimuths_strided() {
    azimuths_within_bound(4001);
    for word in [
        0,
        1,
        u32::MAX,
        1 << 29,
        (1 << 29) - 1,
        1 << 30,
        1 << 31,
        (1 << 31) - 1,
    ] {
        assert!(azimuth_error(word) <= 2.5, "{word:#x}");
    }
}

#[test]
#[ignore = "opt-in, minutes: cargo test --release --test uniforms -- --ignored --nocapture"]
fn azimuths_exhaustive() {
    azimuths_within_bound(1);
}
