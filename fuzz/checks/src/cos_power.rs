//! `CosPower`: which exponents it takes, its moments, and each law's own type at its exponent.

use super::input::Input;
use super::measure::{assert_close, context};
use coslobe::{CosPower, CosSin, ExponentError, Law, Spatial};
use kit::catalogue::{every_number, one_law};
use kit::{Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw};
use std::f64::consts::FRAC_PI_2;

/// A law of its own type against `CosPower` at its exponent.
const AGREE_ULP: f64 = 8.0;

pub(super) fn check(input: Input) {
    every_number(&mut Chosen(input.number_type(5), Some(input)));
}

struct Chosen<'a>(usize, Option<Input<'a>>);

impl NumberVisitor for Chosen<'_> {
    fn number<T: Number>(&mut self) {
        if self.0 > 0 {
            self.0 -= 1;
        } else if let Some(mut input) = self.1.take() {
            match input.law::<T>() {
                Id::CosPower(k) => exponent(T::of(k)),
                law => {
                    let theta = input.number::<T>(0.0, FRAC_PI_2);
                    let at = input.direction::<T>();
                    if theta.nan() || at.sin.nan() {
                        return;
                    }
                    one_law(law, &mut Own { at, theta });
                }
            }
        }
    }
}

/// A law of its own type, at a direction and at an angle.
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

/// CosPower::new takes exactly what it says.
fn exponent<T: Number>(k: T) {
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
    if let Ok(law) = law {
        moments(&law);
    }
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
