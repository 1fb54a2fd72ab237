//! Quantiles against their distribution functions, at any bits.

use super::input::{Words, both};
use super::measure::{assert_close, context};
use coslobe::{Law, Planar, Spatial, Tails};
use kit::catalogue::{every_law, every_number};
use kit::{Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw};

/// F(q − so many ulp) ≤ p ≤ F(q + so many): the plain tier's bound for a quantile.
const BRACKET_STEPS: u32 = 4;
/// F itself is widened by its own rounding errors, in ulp.
const BRACKET_ULP: f64 = 8.0;
/// unwarp(warp(p)) against p in units of 1 + |ln p|: a pair's rounding is multiplied by
/// d ln p / d ln cos, which for p = cosᵏ⁺¹θ is k + 1, at most a few times |ln p| near the horizon.
const ROUND_TRIP_ULP: f64 = 12.0;
/// A quantile may fall by its own rounding, in ulp of the larger angle, where p rises.
const ORDER_ULP: f64 = 4.0;

/// Words: two probabilities.
pub fn check(data: &[u8]) {
    every_number(&mut Check(data));
}

struct Check<'a>(&'a [u8]);

impl NumberVisitor for Check<'_> {
    fn number<T: Number>(&mut self) {
        all::<T>(Words::new(self.0));
    }
}

fn all<T: Number>(mut words: Words) {
    let a = both::<T>(words.word(), 0.0, 1.0);
    let b = both::<T>(words.word(), 0.0, 1.0);
    for (a, b) in [
        (a[0], b[0]),
        (a[1], b[1]),
        (a[0], a[1]),
        (a[1], a[1].above()),
    ] {
        every_law(&mut Probabilities(a, b), &[]);
    }
}

struct Probabilities<T>(T, T);

impl<T: Number> LawVisitor<T> for Probabilities<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        planar(&law, self.0, self.1);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        spatial(&law, self.0, self.1);
    }
}

fn planar<T: Number, L: Planar<T>>(law: &L, a: T, b: T) {
    let _context = context::<T, L>();
    line(law, a, b, -T::END);
    let (q, mirrored) = (law.quantile(a), law.isf(a));
    // At p = ½ both are +0.
    let zeros = q.wide() == 0.0 && mirrored.wide() == 0.0;
    assert!(
        q.nan() || zeros || q.bits() == (-mirrored).bits(),
        "quantile({a:?}) = {q:?}, isf = {mirrored:?}"
    );
}

pub fn spatial<T: Number, L: Spatial<T>>(law: &L, a: T, b: T) {
    let _context = context::<T, L>();
    line(law, a, b, T::of(0.0));
}

fn line<T: Number, L: Law<T>>(law: &L, a: T, b: T, start: T) {
    let domain = |p: T| p.wide() >= 0.0 && p.wide() <= 1.0;
    for p in [a, b] {
        let (q, isf) = (law.quantile(p), law.isf(p));
        if !domain(p) {
            assert!(
                q.nan() && isf.nan(),
                "quantile({p:?}) = {q:?}, isf = {isf:?}"
            );
            continue;
        }
        for theta in [q, isf] {
            assert!(
                theta >= start && theta <= T::END,
                "θ = {theta:?} at p = {p:?}"
            );
        }
        let [before, after] = around(q).map(|theta| law.cdf(theta));
        bracket(p, before, after, q);
        let [after, before] = around(isf).map(|theta| law.sf(theta));
        bracket(p, before, after, isf);
        round_trip(law, Tails::from_lower(p));
        round_trip(law, Tails::from_upper(p));
    }
    if domain(a) && domain(b) {
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        ordered(law.quantile(a), law.quantile(b));
        ordered(law.isf(b), law.isf(a));
    }
}

fn around<T: Number>(theta: T) -> [T; 2] {
    let steps = 0..BRACKET_STEPS;
    [
        steps.clone().fold(theta, |theta, _| theta.below()),
        steps.fold(theta, |theta, _| theta.above()),
    ]
}

#[track_caller]
fn bracket<T: Number>(p: T, before: T, after: T, at: T) {
    let slack = BRACKET_ULP * T::ULP;
    let (low, high) = (before.wide() * (1.0 - slack), after.wide() * (1.0 + slack));
    let inside = low - 2.0 * T::LEAST_STEP <= p.wide() && p.wide() <= high + 2.0 * T::LEAST_STEP;
    assert!(
        inside,
        "p = {p:?} is not within [{before:?}, {after:?}], θ = {at:?}"
    );
}

#[track_caller]
fn round_trip<T: Number, L: Law<T>>(law: &L, p: Tails<T>) {
    let back = law.unwarp_tails(law.warp_tails(p));
    let nearer = if p.upper() <= p.lower() {
        [p, back].map(Tails::upper)
    } else {
        [p, back].map(Tails::lower)
    };
    let [p, back] = nearer.map(T::wide);
    let units = 1.0 + p.max(T::LEAST_STEP).ln().abs();
    assert_close::<T>(back, p, ROUND_TRIP_ULP * units, "unwarp(warp(p))");
}

#[track_caller]
fn ordered<T: Number>(low: T, high: T) {
    let size = low.wide().abs().max(high.wide().abs());
    let slack = ORDER_ULP * T::ULP * size + 2.0 * T::LEAST_STEP;
    assert!(
        low.wide() <= high.wide() + slack,
        "{low:?} comes after {high:?}"
    );
}
