//! Quantiles against their distribution functions, at any bits.

use super::input::Input;
use super::measure::{assert_close, context};
use coslobe::{Law, Tails};
use kit::catalogue::one_law;
use kit::{Id, LawVisitor, Number, PlanarLaw, SpatialLaw};

/// F(q − so many ulp) ≤ p ≤ F(q + so many): the plain tier's bound for a quantile.
const BRACKET_STEPS: u32 = 4;
/// F itself is widened by its own rounding errors, in ulp.
const BRACKET_ULP: f64 = 8.0;
/// unwarp(warp(p)) against p in units of 1 + |ln p|: a pair's rounding is multiplied by
/// d ln p / d ln cos, which for p = cosᵏ⁺¹θ is k + 1, at most a few times |ln p| near the horizon.
const ROUND_TRIP_ULP: f64 = 12.0;
/// A quantile may fall by its own rounding, in ulp of the larger angle, where p rises.
const ORDER_ULP: f64 = 4.0;

/// F(quantile(p)) = p within a bracket, and the same from the upper tail.
pub(super) fn brackets<T: Number>(mut input: Input) {
    let law = input.law::<T>();
    let p = input.number::<T>(0.0, 1.0);
    one_law(law, &mut Brackets(p));
}

/// Of two probabilities, far apart or beside each other.
pub(super) fn order<T: Number>(mut input: Input) {
    let law = input.law::<T>();
    let a: T = input.number(0.0, 1.0);
    let b = if input.flag() {
        a.above()
    } else {
        input.number(0.0, 1.0)
    };
    if domain(a) && domain(b) {
        let (low, high) = if a <= b { (a, b) } else { (b, a) };
        one_law(law, &mut Order(low, high));
    }
}

/// To a direction and back, from either tail.
pub(super) fn round_trips<T: Number>(mut input: Input) {
    let law = input.law::<T>();
    let p: T = input.number(0.0, 1.0);
    if domain(p) {
        one_law(law, &mut RoundTrips(p));
    }
}

fn domain<T: Number>(p: T) -> bool {
    p.wide() >= 0.0 && p.wide() <= 1.0
}

struct Brackets<T>(T);

impl<T: Number> LawVisitor<T> for Brackets<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        bracketed(&law, self.0, -T::END);
        let (q, mirrored) = (law.quantile(self.0), law.isf(self.0));
        // At p = ½ both are +0.
        let zeros = q.wide() == 0.0 && mirrored.wide() == 0.0;
        assert!(
            q.nan() || zeros || q.bits() == (-mirrored).bits(),
            "quantile({:?}) = {q:?}, isf = {mirrored:?}",
            self.0
        );
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        bracketed(&law, self.0, T::of(0.0));
    }
}

struct Order<T>(T, T);

impl<T: Number> LawVisitor<T> for Order<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        ordered_by(&law, self.0, self.1);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        ordered_by(&law, self.0, self.1);
    }
}

struct RoundTrips<T>(T);

impl<T: Number> LawVisitor<T> for RoundTrips<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        round_trip(&law, Tails::from_lower(self.0));
        round_trip(&law, Tails::from_upper(self.0));
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        round_trip(&law, Tails::from_lower(self.0));
        round_trip(&law, Tails::from_upper(self.0));
    }
}

fn bracketed<T: Number, L: Law<T>>(law: &L, p: T, start: T) {
    let _context = context::<T, L>();
    let (q, isf) = (law.quantile(p), law.isf(p));
    if !domain(p) {
        assert!(
            q.nan() && isf.nan(),
            "quantile({p:?}) = {q:?}, isf = {isf:?}"
        );
        return;
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
}

fn ordered_by<T: Number, L: Law<T>>(law: &L, a: T, b: T) {
    let _context = context::<T, L>();
    ordered(law.quantile(a), law.quantile(b));
    ordered(law.isf(b), law.isf(a));
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
    let _context = context::<T, L>();
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
