//! Weights of multiple importance sampling, at any bits.

use super::input::Input;
use coslobe::{balance_heuristic, power_heuristic};
use kit::Number;

/// w(a, b) + w(b, a) against 1.
const SUM_ULP: f64 = 4.0;
/// The weight against its definition in f64, for `f32`; its own error for `f64`.
const VALUE_ULP: f64 = 6.0;

/// Of two densities, often the same. (`lambert_weight` is checked with the densities, which define
/// it.)
pub(super) fn heuristics<T: Number>(mut input: Input) {
    let a = input.number::<T>(0.0, 2.0);
    let b = match input.flag() && input.flag() {
        true => a,
        false => input.number(0.0, 2.0),
    };
    heuristic(balance_heuristic, a, b, |ratio| ratio);
    heuristic(power_heuristic, a, b, |ratio| ratio * ratio);
}

/// `weight(a, b)` = f(a/b) / (1 + f(a/b)).
fn heuristic<T: Number>(weight: fn(T, T) -> T, a: T, b: T, f: fn(f64) -> f64) {
    let (w, mirrored) = (weight(a, b), weight(b, a));
    let (x, y) = (a.wide(), b.wide());
    let valid = x >= 0.0 && y >= 0.0;
    assert_eq!(
        [w.nan(), mirrored.nan()],
        [!valid; 2],
        "{w:?} at {a:?}, {b:?}"
    );
    if !valid {
        return;
    }
    for w in [w, mirrored] {
        assert!(
            (0.0..=1.0).contains(&w.wide()) && !w.negative(),
            "{w:?} at {a:?}, {b:?}"
        );
    }
    let sum = w.wide() + mirrored.wide();
    let expected = if x == 0.0 && y == 0.0 { 0.0 } else { 1.0 };
    assert!(
        (sum - expected).abs() <= SUM_ULP * T::ULP,
        "{w:?} + {mirrored:?} at {a:?}, {b:?}"
    );
    // The limits, then the definition where no limit is near.
    let ratio = f(x / y);
    if x.is_finite() && y.is_finite() && ratio.is_normal() {
        let exact = 1.0 / (1.0 + 1.0 / ratio);
        let slack = VALUE_ULP * T::ULP * exact + 2.0 * T::LEAST_STEP;
        assert!(
            (w.wide() - exact).abs() <= slack,
            "{w:?} is not {exact:?} at {a:?}, {b:?}"
        );
    } else if x.is_infinite() != y.is_infinite() {
        assert_eq!(
            w.wide(),
            f64::from(u8::from(x.is_infinite())),
            "at {a:?}, {b:?}"
        );
    } else if x == y && x > 0.0 {
        assert_eq!(w.wide(), 0.5, "at {a:?}, {b:?}");
    }
}
