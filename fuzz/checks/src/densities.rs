//! Densities and distribution functions, at any bits.

use super::input::Input;
use super::measure::{assert_close, assert_positive_or_zero, context};
use coslobe::{CosSin, Law, Planar, Spatial};
use kit::catalogue::one_law;
use kit::{Id, LawVisitor, Number, PlanarLaw, SpatialLaw};
use std::f64::consts::PI;

/// ln p against the logarithm of p, in ulp of 1 + |ln p|, and so e^(ln p) against p.
const LN_ULP: f64 = 8.0;
/// cdf + sf against 1: the farther tail is 1 minus the nearer one, rounded.
const SUM_ULP: f64 = 1.0;
/// One step up in θ may lower a cdf by its rounding errors.
const STEP_ULP: f64 = 8.0;
/// pdf against the density per steradian times sin θ, three roundings each, more for `CosPower`.
const MEASURE_ULP: f64 = 12.0;
/// No NaN without a NaN for pairs of any length up to this, per component; beyond it a pair is no
/// direction, and ∞/∞ may arise.
const LONGEST: f64 = 1.0;
/// lambert_weight · density against cos θ/π (3D) or cos θ/2 (2D), the definition of the weight.
const WEIGHT_ULP: f64 = 12.0;

/// At an angle.
pub(super) fn at_angle<T: Number>(mut input: Input) {
    let law = input.law::<T>();
    let theta = input.number::<T>(-1.6, 1.6);
    one_law(law, &mut Theta(theta));
}

/// At a pair, of unit length or not.
pub(super) fn at_pair<T: Number>(mut input: Input) {
    let law = input.law::<T>();
    let at = input.pair::<T>();
    one_law(law, &mut Pair(at));
}

struct Theta<T>(T);

impl<T: Number> LawVisitor<T> for Theta<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        planar(&law, self.0);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        spatial(&law, self.0, !matches!(id, Id::CosPower(_)));
    }
}

struct Pair<T>(CosSin<T>);

impl<T: Number> LawVisitor<T> for Pair<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        planar_pair(&law, self.0);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        spatial_pair(&law, self.0);
    }
}

fn planar<T: Number, L: Planar<T>>(law: &L, theta: T) {
    let _context = context::<T, L>();
    let inside = theta >= -T::END && theta <= T::END;
    line(law, theta, inside, true);
    if theta.nan() {
        return;
    }
    assert_eq!(law.pdf(theta).bits(), law.pdf(-theta).bits(), "odd pdf");
    if theta.wide() != 0.0 {
        assert_eq!(
            law.cdf(theta).bits(),
            law.sf(-theta).bits(),
            "cdf(θ) ≠ sf(−θ)"
        );
    }
}

/// `strict`: the density itself cannot underflow, whatever θ.
fn spatial<T: Number, L: Spatial<T>>(law: &L, theta: T, strict: bool) {
    let _context = context::<T, L>();
    let inside = theta.wide() >= 0.0 && theta <= T::END;
    line(law, theta, inside, strict);
    let p = law.pdf_solid_angle(theta);
    assert_eq!(p.nan(), theta.nan());
    if p.nan() {
        return;
    }
    assert_positive_or_zero(p, "pdf_solid_angle");
    assert!(p.wide() < f64::INFINITY && (inside || p.wide() == 0.0));
    assert!(!strict || inside == (p.wide() > 0.0));
    let product = p.wide() * theta.wide().sin().abs();
    if inside && p.wide() >= T::SMALLEST.wide() && product >= T::SMALLEST.wide() {
        assert_close::<T>(law.pdf(theta).wide(), product, MEASURE_ULP, "pdf");
    }
}

/// What holds for every law on the line of θ.
fn line<T: Number, L: Law<T>>(law: &L, theta: T, inside: bool, strict: bool) {
    let (p, ln_p) = (law.pdf(theta), law.ln_pdf(theta));
    let (cdf, sf) = (law.cdf(theta), law.sf(theta));
    let tails = law.tails(theta);
    if theta.nan() {
        let values = [p, ln_p, cdf, sf, tails.lower(), tails.upper()];
        assert!(values.iter().all(|v| v.nan()), "NaN in, {values:?} out");
        return;
    }
    assert_positive_or_zero(p, "pdf");
    assert!(!ln_p.nan());
    assert_eq!(
        [cdf.bits(), sf.bits()],
        [tails.lower(), tails.upper()].map(T::bits)
    );
    for tail in [cdf, sf] {
        assert_positive_or_zero(tail, "tail");
        assert!(tail.wide() <= 1.0, "tail {tail:?} at θ = {theta:?}");
    }
    if !inside {
        let (lower, upper) = if theta.wide() > 0.0 {
            (1.0, 0.0)
        } else {
            (0.0, 1.0)
        };
        assert_eq!(
            [p, ln_p, cdf, sf].map(T::wide),
            [0.0, -f64::INFINITY, lower, upper]
        );
        return;
    }
    assert!(p.wide() < f64::INFINITY, "pdf({theta:?}) = {p:?}");
    let log = ln_p.wide();
    assert!(log < f64::INFINITY);
    // Only q at the axis is zero inside; any other zero is an underflow, which ln_pdf has to show.
    assert!(!strict || theta.wide() == 0.0 || log > -f64::INFINITY);
    assert!(p.wide() == 0.0 || log > -f64::INFINITY);
    if p.wide() >= T::SMALLEST.wide() {
        // Relative to the largest term of the sum, here at most ln of the largest density.
        let largest = 1.0 + log.abs();
        let error = (log - p.wide().ln()).abs() / (T::ULP * largest);
        assert!(
            !strict || error <= LN_ULP,
            "ln_pdf({theta:?}) = {log:?}, pdf = {p:?}"
        );
    }
    assert_close::<T>(cdf.wide() + sf.wide(), 1.0, SUM_ULP, "cdf + sf");
    let next = law.tails(theta.above());
    let slack = STEP_ULP * T::ULP;
    let falls = |a: T, b: T| b.wide() < a.wide() * (1.0 - slack) - 2.0 * T::LEAST_STEP;
    assert!(!falls(cdf, next.lower()), "cdf falls at θ = {theta:?}");
    assert!(!falls(next.upper(), sf), "sf rises at θ = {theta:?}");
}

fn planar_pair<T: Number, L: Planar<T>>(law: &L, at: CosSin<T>) {
    pair(law, at, at.cos.wide() >= 0.0, 0.5);
}

fn spatial_pair<T: Number, L: Spatial<T>>(law: &L, at: CosSin<T>) {
    pair(
        law,
        at,
        at.cos.wide() >= 0.0 && at.sin.wide() >= 0.0,
        1.0 / PI,
    );
}

/// At any pair, of unit length or not. `flat` times cos θ is Lambert's reflected radiance.
fn pair<T: Number, L: Law<T>>(law: &L, at: CosSin<T>, inside: bool, flat: f64) {
    let _context = context::<T, L>();
    let nan = at.cos.nan() || at.sin.nan();
    let (p, weight) = (law.density(at), law.lambert_weight(at));
    let (cdf, sf) = (law.unwarp(at), law.unwarp_sf(at));
    let values = [p, weight, cdf, sf];
    if nan {
        assert!(values.iter().all(|v| v.nan()), "NaN in, {values:?} out");
        return;
    }
    if at.cos.wide().abs() > LONGEST || at.sin.wide().abs() > LONGEST {
        return;
    }
    assert!(!values.iter().any(|v| v.nan()), "{at:?} in, {values:?} out");
    assert_positive_or_zero(p, "density");
    assert_positive_or_zero(weight, "lambert_weight");
    if !inside {
        assert_eq!([p, weight].map(T::wide), [0.0, 0.0], "below the horizon");
        return;
    }
    let length = at.cos.wide().hypot(at.sin.wide());
    if (length - 1.0).abs() > 4.0 * T::ULP {
        return;
    }
    assert!(p.wide() < f64::INFINITY);
    for tail in [cdf, sf] {
        assert_positive_or_zero(tail, "unwarp");
        assert!(tail.wide() <= 1.0, "unwarp {tail:?} at {at:?}");
    }
    let radiance = flat * at.cos.wide();
    let normal = T::SMALLEST.wide()..f64::INFINITY;
    if [p.wide(), weight.wide(), radiance]
        .iter()
        .all(|v| normal.contains(v))
    {
        assert_close::<T>(
            weight.wide() * p.wide(),
            radiance,
            WEIGHT_ULP,
            "weight · density",
        );
    }
}
