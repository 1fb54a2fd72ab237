//! `Fast` keeps its promises: for every random word there is, and for arguments of every kind.

use coslobe::uniform::{azimuth_from_bits, tails_from_bits};
use coslobe::{CosPower, CosSin, Fast, Law};
use kit::catalogue::every_law;
use kit::{Id, LawVisitor, Number, PlanarLaw, SpatialLaw};
use std::f32::consts::FRAC_PI_2;

fn wide<T: Number>(at: CosSin<T>) -> (f64, f64) {
    (at.cos.into(), at.sin.into())
}

/// cos²+ sin² − 1 of one word's direction, if it lies above the horizon with a density to divide
/// by.
fn excess(law: &impl Law<Fast<f32>>, bits: u32) -> Option<f64> {
    let at = law.warp_tails(tails_from_bits(u64::from(bits) << 32));
    excess_at(law, at, bits)
}

fn excess_at(law: &impl Law<Fast<f32>>, at: CosSin<Fast<f32>>, bits: u32) -> Option<f64> {
    let density = law.density(at).0;
    let (cos, sin) = wide(at);
    assert!(
        cos <= 1.0 && sin.abs() <= 1.0,
        "{bits:#010x}: {cos}, {sin}: components once reached 1.000108"
    );
    let inside = cos > 0.0 && density > 0.0 && density.is_finite();
    inside.then_some(cos * cos + sin * sin - 1.0)
}

/// Every `stride`-th word, and those beside every power of two from both sides.
fn words_in_strides(stride: usize) -> impl Iterator<Item = u32> {
    let beside = |n: u32| [(1 << n) - 1, 1 << n, (1 << n) + 1];
    let powers = (0..32).flat_map(beside).flat_map(|word| [word, !word]);
    (0..=u32::MAX).step_by(stride).chain(powers)
}

/// ‖d‖² = cos² + sin² (cos²φ + sin²φ): a direction's own error and, in space, the azimuth's.
const SQUARE: f64 = 1.0 / 2048.0;

fn every_tail(name: Id, law: &impl Law<Fast<f32>>, stride: usize) -> f64 {
    let mut worst = (0.0f64, 0);
    for bits in words_in_strides(stride) {
        let Some(excess) = excess(law, bits) else {
            panic!("{name}: no density at the tail word {bits:#010x}");
        };
        if excess.abs() > worst.0 {
            worst = (excess.abs(), bits);
        }
    }
    println!(
        "{name}: |cos² + sin² − 1| ≤ 2^{:.2}, at {:#010x}",
        worst.0.log2(),
        worst.1
    );
    worst.0
}

/// Samples, of which some laws make θ of two words.
fn pairs_of_words(name: Id, law: &impl Law<Fast<f32>>, at: impl Fn(u64) -> CosSin<Fast<f32>>) {
    for upper in words_in_strides(0x0100_4001) {
        for lower in words_in_strides(0x0100_8003) {
            let excess = excess_at(law, at(u64::from(upper) << 32 | u64::from(lower)), lower);
            let within = excess.is_some_and(|e| e.abs() <= SQUARE);
            assert!(within, "{name}: {upper:#010x} {lower:#010x}: {excess:?}");
        }
    }
}

fn every_turn(stride: usize) -> f64 {
    let worst = words_in_strides(stride).fold(0.0, |worst: f64, bits| {
        let (cos, sin) = wide(azimuth_from_bits::<Fast<f32>>(bits));
        assert!(
            cos.abs() <= 1.0 && sin.abs() <= 1.0,
            "{bits:#010x}: {cos}, {sin}"
        );
        worst.max((cos * cos + sin * sin - 1.0).abs())
    });
    println!("azimuth: |cos² + sin² − 1| ≤ 2^{:.2}", worst.log2());
    worst
}

/// The worst of all laws.
struct Tails {
    stride: usize,
    planar: f64,
    spatial: f64,
}

impl LawVisitor<Fast<f32>> for Tails {
    fn planar<L: PlanarLaw<Fast<f32>>>(&mut self, id: Id, law: L) {
        pairs_of_words(id, &law, |bits| {
            let [sin, cos] = law.sample_from_bits(bits);
            CosSin { cos, sin }
        });
        let worst = every_tail(id, &law, self.stride);
        self.planar = self.planar.max(worst);
    }
    fn spatial<L: SpatialLaw<Fast<f32>>>(&mut self, id: Id, law: L) {
        pairs_of_words(id, &law, |bits| law.angle_from_bits(bits));
        let worst = every_tail(id, &law, self.stride);
        self.spatial = self.spatial.max(worst);
    }
}

fn fast_keeps_its_promises(stride: usize) {
    let mut worst = Tails {
        stride,
        planar: 0.0,
        spatial: 0.0,
    };
    every_law(&mut worst, &[0.5, 100.0]);
    assert!(worst.planar <= SQUARE, "{:e}", worst.planar);
    let direction = worst.spatial + every_turn(stride);
    assert!(direction <= SQUARE, "{direction:e}");
}

#[test]
fn fast_in_strides() {
    fast_keeps_its_promises(4099);
}

#[test]
#[ignore = "opt-in, minutes: cargo test --release --test directions -- --ignored --nocapture"]
fn fast_for_every_word() {
    fast_keeps_its_promises(1);
}

/// 0, all ones and alternating bits, alone and as what a stuck generator repeats.
#[test]
fn fast_at_extreme_words() {
    let words = [0u32, !0, 1 << 31, !0 >> 1, 0x5555_5555, 0xAAAA_AAAA, 1, !1];
    for k in [0.0, 1e-30, 0.5, 7.3, 1e4, 1e12, 1e30, f32::MAX] {
        let law = CosPower::new(Fast(k)).expect("a valid exponent");
        for bits in words {
            let excess = excess(&law, bits);
            assert!(
                excess.is_some_and(|e| e.abs() <= SQUARE),
                "k = {k:e}, word {bits:#x}: {excess:?}"
            );
        }
    }
}

/// Angles beyond the support's end, and numbers that are no probability.
const BEYOND: [f32; 8] = [FRAC_PI_2, 1.6, 2.0, 3.2, 1e10, 1e38, MAX, INF];
const IMPROBABLE: [f32; 8] = [-1e-45, -0.5, -1.0, 1.0000001, 2.0, MAX, INF, -INF];
const MAX: f32 = f32::MAX;
const INF: f32 = f32::INFINITY;

fn total(name: Id, law: &impl Law<Fast<f32>>, start: f32) {
    let nan = Fast(f32::NAN);
    let at = |cos, sin| CosSin { cos, sin };
    let mut out = vec![law.pdf(nan), law.ln_pdf(nan), law.cdf(nan), law.sf(nan)];
    let (a, b) = (law.warp(nan), law.warp_sf(nan));
    out.extend([law.quantile(nan), law.isf(nan), a.cos, a.sin, b.cos, b.sin]);
    for pair in [at(nan, Fast(0.5)), at(Fast(0.5), nan), at(nan, nan)] {
        out.extend([law.density(pair), law.unwarp(pair), law.unwarp_sf(pair)]);
        out.push(law.lambert_weight(pair));
    }
    for p in IMPROBABLE.map(Fast) {
        let (a, b) = (law.warp(p), law.warp_sf(p));
        out.extend([law.quantile(p), law.isf(p), a.cos, a.sin, b.cos, b.sin]);
    }
    for (i, x) in out.iter().enumerate() {
        assert!(x.0.is_nan(), "{name}: {i} is {x:?}");
    }
    for theta in BEYOND {
        for (theta, tails) in [(theta, [1.0, 0.0]), (-theta, [0.0, 1.0])].map(|(x, t)| (Fast(x), t))
        {
            let got = [
                law.pdf(theta),
                law.ln_pdf(theta),
                law.cdf(theta),
                law.sf(theta),
            ];
            let want = [0.0, f32::NEG_INFINITY, tails[0], tails[1]];
            assert_eq!(got.map(|x| x.0), want, "{name} at {theta:?}");
        }
    }
    let end = 1.570_796_2;
    for bits in (0..=1.0f32.to_bits())
        .step_by(1009)
        .chain([1.0f32.to_bits()])
    {
        let p = Fast(f32::from_bits(bits));
        for theta in [law.quantile(p).0, law.isf(p).0] {
            assert!(
                theta >= start && theta <= end && law.pdf(Fast(theta)).0 >= 0.0,
                "{name}: θ = {theta:e} at {p:?}"
            );
        }
    }
}

struct Total;

impl LawVisitor<Fast<f32>> for Total {
    fn planar<L: PlanarLaw<Fast<f32>>>(&mut self, id: Id, law: L) {
        total(id, &law, -1.570_796_2);
    }
    fn spatial<L: SpatialLaw<Fast<f32>>>(&mut self, id: Id, law: L) {
        total(id, &law, 0.0);
        for theta in BEYOND.map(Fast) {
            assert_eq!(law.pdf_solid_angle(theta).0, 0.0);
        }
    }
}

#[test]
fn fast_is_total() {
    every_law(
        &mut Total,
        &[0.0, 1e-30, 0.5, 1.0, 7.3, 1e4, 1e30, f32::MAX.into()],
    );
    assert!(CosPower::new(Fast(f32::NAN)).is_err() && CosPower::new(Fast(-1.0f32)).is_err());
}

/// What every law means by a pair below the horizon.
#[test]
fn fast_has_no_density_below_the_horizon() {
    for (cos, sin) in [(-0.6, 0.8), (-1e-30, 1.0), (-1.0, 0.0)] {
        let at = CosSin {
            cos: Fast(cos),
            sin: Fast(sin),
        };
        every_law(&mut Below(at), &[7.3]);
    }
}

struct Below(CosSin<Fast<f32>>);

impl Below {
    fn none(&self, id: Id, law: &impl Law<Fast<f32>>) {
        let found = [law.density(self.0), law.lambert_weight(self.0)];
        assert_eq!(found, [Fast(0.0); 2], "{id} at {:?}", self.0);
    }
}

impl LawVisitor<Fast<f32>> for Below {
    fn planar<L: PlanarLaw<Fast<f32>>>(&mut self, id: Id, law: L) {
        self.none(id, &law);
    }
    fn spatial<L: SpatialLaw<Fast<f32>>>(&mut self, id: Id, law: L) {
        self.none(id, &law);
    }
}

/// The largest scales meet the smallest powers: once 0 for 5.9e-39.
#[test]
fn fast_density_of_a_large_exponent_is_not_lost() {
    let law = CosPower::new(Fast(f32::from_bits(0x7f63_f798))).expect("a valid exponent");
    let at = CosSin {
        cos: Fast(1.0),
        sin: Fast(f32::from_bits(0x219e_822b)),
    };
    let density = f64::from(law.density(at).0);
    assert!((density / 5.9e-39 - 1.0).abs() < 0.01, "{density:e}");
}
