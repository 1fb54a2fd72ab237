//! Points before normalisation: distances and densities against the formulas in wider arithmetic.

use coslobe::{Ball, CosSin, Disk, Lambert, Measure, Precise, Radius, SphereShell, Tangent};
use kit::Number;
use kit::accuracy::format::{Format, ulp};
use kit::accuracy::wide::Wide;
use kit::catalogue::{self, every_number};
use kit::{Id, LawVisitor, NumberVisitor, PlanarLaw, SpatialLaw, TangentLaw};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

/// Allowed ulps of distances and densities: as the docs of `Tangent` state, or 2⁻¹².
fn allowed<T: Number>() -> f64 {
    match T::NAME {
        "Precise<f32>" => 0.5,
        "Precise<f64>" => 0.55,
        _ => (T::ERROR / T::EPSILON).max(4.0),
    }
}

type Fine<T> = <<T as Number>::Raw as Format>::Fine;

fn fine<T: Number>(x: T) -> Fine<T> {
    Fine::<T>::of(x.wide())
}

/// |got − want| in ulps of the larger of `want` and `scale`; subnormal values in theirs.
fn error<T: Number>(got: T, want: Fine<T>, scale: f64) -> f64 {
    let (near, raw) = (want.near(), got.wide());
    let beyond = near >= T::Raw::MAX_VALUE + ulp::<T::Raw>(T::Raw::MAX_VALUE) / 2.0;
    if raw.is_infinite() && (beyond || near == raw) {
        return 0.0;
    }
    let size = near.abs().max(scale);
    let lift = if size < 1e-200 { 600 } else { 0 };
    let apart = (want - fine(got)).lifted(lift).hi.abs();
    let error = apart / (ulp::<T::Raw>(size) * 2f64.powi(lift));
    if error.is_nan() { f64::INFINITY } else { error }
}

/// 2ρ cos θ times the root of v that the measure takes.
fn distance<W: Wide>(measure: Measure, rho: W, cos: W, v: W) -> W {
    let share = match measure {
        Measure::Area => v.root(),
        Measure::Volume => v.cube_root(),
        _ => W::of(1.0),
    };
    rho * W::of(2.0) * cos * share
}

/// The density, then its logarithm and the size of the logarithm's largest term.
fn density<W: Wide>(measure: Measure, rho: W, cos: W, sin: W) -> (W, W, f64) {
    let (one, pi) = (W::of(1.0), W::pi());
    let (coefficient, power) = match measure {
        Measure::Area => (one / pi, 2),
        Measure::ArcLength => (one / (pi * W::of(2.0)), 1),
        Measure::Volume => (W::of(3.0) / (pi * W::of(4.0)), 3),
        Measure::SurfaceArea => (one / (pi * W::of(4.0)), 2),
        Measure::CircleShell => {
            let scale = W::of(0.5);
            return (cos * scale, cos.ln() + scale.ln(), cos.ln().near().abs());
        }
        Measure::SphereShell => {
            let scale = W::of(3.0) / (pi * W::of(2.0));
            let ln_cos_squared = cos.ln() * W::of(2.0);
            let terms = ln_cos_squared.near().abs().max(sin.ln().near().abs());
            let log = scale.ln() + ln_cos_squared + sin.ln();
            return (cos * cos * sin * scale, log, terms);
        }
    };
    let value = (0..power).fold(coefficient, |value, _| value / rho);
    let ln_power = rho.ln() * W::of(f64::from(power));
    let log = coefficient.ln() - ln_power;
    (value, log, ln_power.near().abs())
}

fn judge<T: Number, L: Tangent<T>>(law: &L, rho: T, at: CosSin<T>, v: T) {
    let allowed = allowed::<T>();
    let radius = Radius::new(rho).expect("a valid radius");
    let r = law.distance(radius, at, v);
    let place = format!("{:?} {} rho {rho:?} {at:?} v {v:?}", L::MEASURE, T::NAME);
    let far = distance(L::MEASURE, fine(rho), fine(at.cos), fine(v));
    let off = error(r, far, 0.0);
    assert!(off <= allowed, "{place}: distance {r:?} off by {off} ulp");
    let (value, log, terms) = density(L::MEASURE, fine(rho), fine(at.cos), fine(at.sin));
    let got = law.point_density(radius, at, r);
    let off = error(got, value, 0.0);
    assert!(off <= allowed, "{place}: density {got:?} off by {off} ulp");
    let got = law.ln_point_density(radius, at, r);
    let off = error(got, log, terms.max(1.0));
    assert!(
        off <= allowed,
        "{place}: ln density {got:?} off by {off} ulp"
    );
    if matches!(L::MEASURE, Measure::Area | Measure::Volume) {
        let reach = fine(rho) * Fine::<T>::of(2.0) * fine(at.cos);
        let beyond = reach.near() * 1.001 + ulp::<T::Raw>(0.0) * 2.0;
        let beyond = T::of(beyond);
        assert_eq!(law.point_density(radius, at, beyond), T::ZERO, "{place}");
        assert_eq!(
            law.ln_point_density(radius, at, beyond),
            -T::INFINITY,
            "{place}"
        );
    }
}

struct Judge<T> {
    rho: T,
    at: CosSin<T>,
    v: T,
}

impl<T: Number> LawVisitor<T> for Judge<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        judge(&law, self.rho, self.at, self.v);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, _: L) {}
    fn tangent<L: TangentLaw<T>>(&mut self, _: Id, law: L) {
        judge(&law, self.rho, self.at, self.v);
    }
}

fn every_law<T: Number>(rho: T, at: CosSin<T>, v: T) {
    catalogue::every_law(&mut Judge { rho, at, v }, &[]);
}

/// The pair of a cosine or of a sine, the other component rounded.
fn pair<T: Number>(x: T, is_cos: bool) -> CosSin<T> {
    let one = Fine::<T>::of(1.0);
    let other = T::of((one - fine(x) * fine(x)).root().near());
    if is_cos {
        CosSin { cos: x, sin: other }
    } else {
        CosSin { cos: other, sin: x }
    }
}

/// Radii over the whole admitted range, the ends included; cosines, sines and v by their logarithm
/// down to the least number that the type tells from 0.
fn everywhere<T: Number>() {
    let mut rng = Pcg64::seed_from_u64(17);
    let mut unit = move || (rng.next_u64() >> 12) as f64 / 2f64.powi(52) + 2f64.powi(-53);
    let least = 2f64.powi(T::Raw::LEAST);
    let (low, high) = (least.log2(), (T::Raw::MAX_VALUE / 4.0).log2());
    let one = T::Raw::of(1.0).bits();
    let floor = T::Raw::of(T::LEAST_STEP).bits() as f64;
    for i in 0..40_000 {
        let rho = match i {
            0 => least,
            1 => T::Raw::MAX_VALUE / 4.0,
            _ => 2f64
                .powf(low + (high - low) * unit())
                .clamp(least, T::Raw::MAX_VALUE / 4.0),
        };
        let rho = T::of(rho);
        let mut logarithmic = || {
            let bits = floor + (one as f64 - floor) * unit();
            T::of_raw(T::Raw::of_bits(bits as u64))
        };
        let [x, v] = [logarithmic(), logarithmic()];
        if i % 2 == 0 {
            every_law(rho, pair(x, i % 4 == 0), v);
        } else {
            let (x, v) = (T::of(unit()), T::of(unit()));
            every_law(rho, pair(x, i % 4 == 1), v);
        }
    }
}

struct Everywhere;

impl NumberVisitor for Everywhere {
    fn number<T: Number>(&mut self) {
        everywhere::<T>();
    }
}

#[test]
fn points_in_every_number_type() {
    every_number(&mut Everywhere);
}

/// Products that were 0, or had lost most of their digits, before the large factor came.
#[test]
fn distances_of_tiny_cosines() {
    let rho = f64::from_bits(0x7e37_e43c_8800_759c);
    let far = |cos: u64| pair(f64::from_bits(cos), true);
    let v = f64::from_bits(0x01a5_6e1f_c2f8_f359);
    let precise = |x: f64| Precise(x);
    let typed = |at: CosSin<f64>| CosSin {
        cos: precise(at.cos),
        sin: precise(at.sin),
    };
    for (at, v) in [
        (far(0x1668_7e92_154e_f7ac), v),
        (far(0x0000_1268_8b70_e62b), 0.3),
    ] {
        every_law(rho, at, v);
        every_law(precise(rho), typed(at), precise(v));
    }
}

/// Logarithms of densities that underflow.
#[test]
fn logarithms_of_tiny_densities() {
    let rho = Radius::new(1.0f32).expect("a valid radius");
    for (cos, want) in [(1e-30, -138.894), (1e-22, -102.053)] {
        let at = pair(cos, true);
        let got = SphereShell.ln_point_density(rho, at, 0.0);
        assert!((got - want).abs() < 2e-3, "{cos:e}: {got}");
        every_law(1.0, at, 1.0);
    }
}

/// A direction outside the support has no points, and a shell's density keeps its sign.
#[test]
fn no_points_outside_the_support() {
    let rho = Radius::new(1.0f64).expect("a valid radius");
    for at in [
        CosSin {
            cos: -0.6,
            sin: 0.8,
        },
        CosSin {
            cos: 0.8,
            sin: -0.6,
        },
    ] {
        assert_eq!(Ball.point_density(rho, at, 0.1), 0.0);
        assert_eq!(Lambert.point_density(rho, at, 0.1), 0.0);
        assert_eq!(
            SphereShell.ln_point_density(rho, at, 0.1),
            f64::NEG_INFINITY
        );
    }
    let mirrored = CosSin {
        cos: 0.8,
        sin: -0.6,
    };
    assert!(Disk.point_density(rho, mirrored, 0.1) > 0.0);
    assert!(Disk.point_density(rho, mirrored, f64::NAN).is_nan());
}
