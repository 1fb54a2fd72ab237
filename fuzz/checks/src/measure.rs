//! Comparisons.

use kit::Number;

/// |a − b| within `ulps` units of the format relative to b, or two of its smallest numbers.
#[track_caller]
pub(super) fn assert_close<T: Number>(a: f64, b: f64, ulps: f64, what: &str) {
    let slack = ulps * T::ULP * b.abs() + 2.0 * T::LEAST_STEP;
    assert!(
        a == b || (a - b).abs() <= slack,
        "{what}: {a:?} is not within {ulps} ulp of {b:?}"
    );
}

/// x² + y² + … − 1 with an error far below f64's ulp, by exact products and sums.
fn norm_excess(v: &[f64]) -> f64 {
    let (mut high, mut low) = (-1.0, 0.0);
    for &x in v {
        let square = x * x;
        let sum = high + square;
        let part = sum - high;
        low += (high - (sum - part)) + (square - part) + x.mul_add(x, -square);
        high = sum;
    }
    high + low
}

/// The length of `v` is 1 to `ulps` units of 1.
#[track_caller]
pub(super) fn assert_unit<T: Number, const N: usize>(v: [T; N], ulps: f64) {
    // |v|² − 1 is twice |v| − 1 to first order.
    let excess = norm_excess(&v.map(T::wide)) / 2.0;
    assert!(
        excess.abs() <= ulps * T::ULP,
        "the length of {v:?} is off by {:.2} ulp of 1",
        excess / T::ULP
    );
}

/// Not NaN, and not below zero (nor −0).
#[track_caller]
pub(super) fn assert_positive_or_zero<T: Number>(x: T, what: &str) {
    assert!(!x.nan() && !x.negative(), "{what} is {x:?}");
}

/// Says which law and format failed, without a message in every assertion.
pub(super) struct Context(fn() -> &'static str);

impl Drop for Context {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("while checking {}", (self.0)());
        }
    }
}

/// Held while a law is checked.
pub(super) fn context<T: Number, L>() -> Context {
    Context(std::any::type_name::<(L, T)>)
}
