//! The promises of every law, for any exponent.

use super::input::{Words, both, pair_at, unit};
use super::measure::{assert_close, context};
use super::{densities, quantiles, samples, warps};
use coslobe::{CosPower, CosSin, ExponentError, Law, Spatial};
use kit::catalogue::{every_law, every_number};
use kit::{Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw};
use std::f64::consts::{FRAC_PI_2, TAU};

/// A law of its own type against `CosPower` at its exponent.
const AGREE_ULP: f64 = 8.0;
/// `f32` against the same formula in `f64`: the plain tier's bound.
const REFERENCE_ULP: f64 = 4.0;

/// Words: k; θ or cos θ; sin θ or a probability; a second one. The whole input is the generator.
pub fn check(data: &[u8]) {
    every_number(&mut Check(data));
    let mut words = Words::new(data);
    let ks = both::<f32>(words.word(), 0.0, 1e4);
    let thetas = both::<f32>(words.word(), 0.0, FRAC_PI_2);
    for law in ks.into_iter().filter_map(law) {
        for theta in thetas {
            reference(&law, theta);
        }
    }
}

struct Check<'a>(&'a [u8]);

impl NumberVisitor for Check<'_> {
    fn number<T: Number>(&mut self) {
        all::<T>(self.0);
    }
}

fn all<T: Number>(data: &[u8]) {
    let mut words = Words::new(data);
    let [bits, even] = both::<T>(words.word(), 0.0, 64.0);
    let (a, b, c) = (words.word(), words.word(), words.word());
    for k in [bits, even] {
        let Some(law) = law(k) else { continue };
        for theta in both::<T>(a, -0.1, 1.6) {
            densities::spatial(&law, theta, false);
        }
        let any = CosSin {
            cos: T::of_bits(a),
            sin: T::of_bits(b),
        };
        let angle = FRAC_PI_2 * unit::<T>(b).wide();
        for at in [any, pair_at(angle), pair_at(-angle)] {
            densities::spatial_pair(&law, at);
        }
        let (p, q) = (both::<T>(b, 0.0, 1.0), both::<T>(c, 0.0, 1.0));
        for (p, q) in [(p[0], q[0]), (p[1], q[1]), (p[0], q[1])] {
            quantiles::spatial(&law, p, q);
            warps::spatial(&law, p, q);
        }
        samples::spatial(&law, data);
        moments(&law);
    }
    let angle = FRAC_PI_2 * unit::<T>(a).wide();
    let (at, theta) = (pair_at(angle), T::of(angle));
    every_law::<T>(&mut Own { at, theta }, &[]);
}

/// A law of its own type, at a direction and its angle.
struct Own<T> {
    at: CosSin<T>,
    theta: T,
}

impl<T: Number> LawVisitor<T> for Own<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, _: L) {}
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        agrees(&law, id.exponent(), self.at, self.theta);
    }
}

/// `f32` against the formula in `f64`, whose 29 more bits outlast any k that leaves cosᵏθ normal.
fn reference(law: &CosPower<f32>, theta: f32) {
    let (k, x) = (law.exponent().wide(), theta.wide());
    if !(x >= 0.0 && theta <= <f32 as Number>::END) {
        return;
    }
    let ln_cos = if x < 0.5 {
        (-x.sin() * x.sin()).ln_1p() / 2.0
    } else {
        x.cos().ln()
    };
    let density = (k + 1.0) / TAU * (k * ln_cos).exp();
    let pairs = [
        (law.pdf_solid_angle(theta), density),
        (law.pdf(theta), density * x.sin()),
        (law.sf(theta), ((k + 1.0) * ln_cos).exp()),
        (law.cdf(theta), -((k + 1.0) * ln_cos).exp_m1()),
    ];
    for (value, exact) in pairs {
        if exact >= f32::SMALLEST.wide() {
            assert_close::<f32>(value.wide(), exact, REFERENCE_ULP, "CosPower against f64");
        }
    }
}

/// CosPower::new takes exactly what it says.
fn law<T: Number>(k: T) -> Option<CosPower<T>> {
    let x = k.wide();
    let expected = if x.is_nan() {
        Err(ExponentError::NotANumber)
    } else if x < 0.0 {
        Err(ExponentError::Negative)
    } else if x.is_infinite() {
        Err(ExponentError::Infinite)
    } else {
        Ok(x)
    };
    let law = CosPower::new(k);
    assert_eq!(law.map(|law| law.exponent().wide()), expected);
    law.ok()
}

/// Finite, and in the ranges that any direction above the horizon keeps to.
fn moments<T: Number>(law: &CosPower<T>) {
    let m = law.moments();
    let values = [m.mean_cos, m.var_cos, m.mean_theta, m.var_theta, m.entropy].map(T::wide);
    assert!(values.iter().all(|v| v.is_finite()), "{m:?} of {law:?}");
    let [mean_cos, var_cos, mean_theta, ..] = values;
    assert!(
        (0.5..=1.0).contains(&mean_cos) && var_cos >= 0.0,
        "{m:?} of {law:?}"
    );
    assert!((0.0..FRAC_PI_2).contains(&mean_theta), "{m:?} of {law:?}");
}

fn agrees<T: Number, L: Spatial<T>>(law: &L, k: f64, at: CosSin<T>, theta: T) {
    let _context = context::<T, L>();
    let power = CosPower::new(T::of(k)).expect("a finite exponent ≥ 0");
    let pairs = [
        (power.pdf(theta), law.pdf(theta)),
        (power.cdf(theta), law.cdf(theta)),
        (power.sf(theta), law.sf(theta)),
        (power.density(at), law.density(at)),
        (power.unwarp(at), law.unwarp(at)),
    ];
    for (a, b) in pairs {
        assert_close::<T>(
            a.wide(),
            b.wide(),
            AGREE_ULP,
            "CosPower against the law's own type",
        );
    }
}
