//! Relative errors of samples and of peers by decade of the tail: one measure for all.

use super::inputs::{Uniforms, tails};
use crate::accuracy::format::Format;
use crate::accuracy::inverse::warp;
use crate::accuracy::reference::Id;
use crate::accuracy::wide::Wide;
use std::collections::BTreeMap;

/// The tail: p at most this, as `tests/kit/src/accuracy` has it.
const TAIL: f64 = 1.0 / (1 << 20) as f64;

/// Worst relative errors by decade ⌊log₁₀ p⌋ of the nearer tail p, and in the tail.
#[derive(Clone, Debug, Default)]
pub struct Errors {
    pub decades: BTreeMap<i32, f64>,
    pub in_tail: Option<f64>,
    pub inputs: u64,
}

impl Errors {
    pub fn note(&mut self, p: f64, error: f64) {
        let error = if error.is_nan() { f64::INFINITY } else { error };
        let decade = p.max(f64::MIN_POSITIVE).log10().floor() as i32;
        let worst = self.decades.entry(decade).or_default();
        *worst = worst.max(error);
        if p <= TAIL {
            self.in_tail = Some(self.in_tail.map_or(error, |e| e.max(error)));
        }
        self.inputs += 1;
    }

    pub fn worst(&self) -> f64 {
        self.decades.values().fold(0.0, |a, &b| a.max(b))
    }
}

/// |got − want| / |want|; an exact zero is no error.
pub fn relative<W: Wide>(got: W, want: W) -> f64 {
    let difference = (got - want).near().abs();
    if difference == 0.0 {
        0.0
    } else {
        difference / want.near().abs()
    }
}

/// The larger relative error of (cos θ, sin θ).
pub fn of_pair<W: Wide>(got: (W, W), want: (W, W)) -> f64 {
    relative(got.0, want.0).max(relative(got.1, want.1))
}

/// (cos θ, sin θ) that a direction with axis +y holds; sin θ without its sign.
pub fn polar<T: Format>(d: &[T]) -> (T::Wide, T::Wide) {
    let w = |x: T| T::Wide::of(x.wide());
    match *d {
        [sin, cos] => (w(cos), w(sin)),
        [x, y, z] => {
            // Scaled by a power of two: squares of the least components would underflow.
            let scale = T::Wide::of(2f64.powi(if T::DIGITS == 24 { 0 } else { 200 }));
            let (x, z) = (w(x) * scale, w(z) * scale);
            (w(y), (x * x + z * z).root() / scale)
        }
        _ => unreachable!("directions have two or three components"),
    }
}

/// The true (cos θ, sin θ) where the cdf (or, if `upper`, the sf) is u, and the nearer tail.
fn truth<T: Format>(law: Id, u: T, upper: bool) -> ((T::Wide, T::Wide), f64) {
    let far = u.wide() > 0.5;
    let p = if far { 1.0 - u.wide() } else { u.wide() };
    let nearer_is_upper = upper != far;
    let (cos, sin) = warp::<T::Wide>(law, p, nearer_is_upper);
    let negative = law.planar() && !nearer_is_upper;
    ((cos, if negative { -sin } else { sin }), p)
}

/// The tails p and 1 − p as numbers of the format, but for those that round to 1.
fn both_sides<T: Format>(from: Uniforms, n: u32) -> Vec<T> {
    let p = tails::<T>(from, n);
    let one = T::of(1.0);
    let far = p.iter().map(|&p| one - p).filter(|&u| u < one);
    p.iter().copied().chain(far).collect()
}

/// An azimuth in turns for each u, all around: its errors show in a direction's length.
pub fn azimuth<T: Format>(u: T) -> T {
    let spread = u.bits().wrapping_mul(0x9E37_79B9_7F4A_7C15) >> 40;
    T::of(spread as f64 / f64::from(1 << 24))
}

/// Errors of a map from the cdf (or, if `upper`, the sf) to a direction.
pub fn of_map<T: Format, const N: usize>(
    law: Id,
    upper: bool,
    from: Uniforms,
    n: u32,
    map: impl Fn(T) -> [T; N],
) -> Errors {
    let mut errors = Errors::default();
    for u in both_sides::<T>(from, n) {
        let (want, p) = truth(law, u, upper);
        errors.note(p, of_pair(polar(&map(u)), want));
    }
    errors
}

/// Errors of a law's own two entries: p as the cdf and as the sf.
pub fn of_entries<T: Format, const N: usize>(
    law: Id,
    from: Uniforms,
    n: u32,
    lower: impl Fn(T) -> [T; N],
    upper: impl Fn(T) -> [T; N],
) -> Errors {
    let mut errors = Errors::default();
    for p in tails::<T>(from, n) {
        for (got, is_upper) in [(lower(p), false), (upper(p), true)] {
            let (want, p) = truth(law, p, is_upper);
            errors.note(p, of_pair(polar(&got), want));
        }
    }
    errors
}

/// Errors of a quantile: θ at cdf = u.
pub fn of_quantile<T: Format>(law: Id, n: u32, quantile: impl Fn(T) -> T) -> Errors {
    let mut errors = Errors::default();
    for u in both_sides::<T>(Uniforms::All, n) {
        let ((cos, sin), p) = truth(law, u, false);
        let negative = sin.near() < 0.0;
        let theta = T::Wide::angle(cos, if negative { -sin } else { sin });
        let theta = if negative { -theta } else { theta };
        errors.note(p, relative(T::Wide::of(quantile(u).wide()), theta));
    }
    errors
}

/// Errors of a function of θ, by decade of the distance from the nearer end of [0, π/2].
pub fn of_angle<T: Format>(
    angles: &[T],
    got: impl Fn(T) -> T,
    want: impl Fn(f64) -> T::Wide,
) -> Errors {
    let mut errors = Errors::default();
    for &theta in angles {
        let end = std::f64::consts::FRAC_PI_2 - theta.wide().abs();
        let p = theta.wide().abs().min(end);
        let truth = want(theta.wide());
        errors.note(p, relative(T::Wide::of(got(theta).wide()), truth));
    }
    errors
}
