//! Points of the disk, circle, ball and sphere, at any radius.

use super::input::{Input, Words};
use super::measure::{assert_close, assert_positive_or_zero, context};
use super::samples::of_direction;
use coslobe::{CosSin, Measure, PlanarPoint, Radius, RadiusError, SpatialPoint, Tangent};
use kit::catalogue::one_law;
use kit::{Drawn, Id, LawVisitor, Number, PlanarLaw, SpatialLaw, TangentLaw};

/// ln_point_density against the logarithm of point_density, in ulp of its largest term: 3 ln ρ.
const LN_ULP: f64 = 8.0;
/// A distance against the formula in `f64`, which errs too.
const DISTANCE_ULP: f64 = 6.0;
/// The point's own length against 2ρ cos θ, which it must not pass by more than rounding.
const LENGTH_ULP: f64 = 4.0;

/// Of a point in any direction and at any distance.
pub(super) fn densities<T: Number>(mut input: Input) {
    let law = input.law::<T>();
    let Some(rho) = radius::<T>(input.number(0.0, 4.0)) else {
        return;
    };
    let (at, r) = (input.pair(), input.number(0.0, 8.0));
    let v = input.number(0.0, 1.0);
    one_law(law, &mut Densities { rho, at, r, v });
}

/// Points drawn, with their densities.
pub(super) fn draws<T: Number>(mut input: Input) {
    let law = input.law::<T>();
    if let Some(rho) = radius::<T>(input.number(0.0, 4.0)) {
        let words = &input.words;
        one_law(law, &mut Points { rho, words });
    }
}

struct Densities<T> {
    rho: Radius<T>,
    at: CosSin<T>,
    r: T,
    v: T,
}

impl<T: Number> LawVisitor<T> for Densities<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        density(&law, self.rho, self.at, self.r);
        distance(&law, self.rho, self.at.cos, self.v);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, _: L) {}
    fn tangent<L: TangentLaw<T>>(&mut self, _: Id, law: L) {
        density(&law, self.rho, self.at, self.r);
        distance(&law, self.rho, self.at.cos, self.v);
    }
}

struct Points<'a, T> {
    rho: Radius<T>,
    words: &'a Words<'a>,
}

impl<T: Number> LawVisitor<T> for Points<'_, T> {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        planar(id, &law, self.rho, self.words);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, _: L) {}
    fn tangent<L: TangentLaw<T>>(&mut self, id: Id, law: L) {
        spatial(id, &law, self.rho, self.words);
    }
}

/// Radius::new takes exactly what it says.
fn radius<T: Number>(rho: T) -> Option<Radius<T>> {
    let x = rho.wide();
    let expected = if x.is_nan() {
        Err(RadiusError::NotANumber)
    } else if x < T::SMALLEST.wide() {
        Err(RadiusError::TooSmall)
    } else if x > T::LARGEST.wide() / 4.0 {
        Err(RadiusError::TooLarge)
    } else {
        Ok(rho)
    };
    let radius = Radius::new(rho);
    assert_eq!(radius.map(Radius::get), expected);
    radius.ok()
}

fn reads_r(measure: Measure) -> bool {
    matches!(measure, Measure::Area | Measure::Volume)
}

fn in_space(measure: Measure) -> bool {
    use Measure::{SphereShell, SurfaceArea, Volume};
    matches!(measure, Volume | SurfaceArea | SphereShell)
}

fn density<T: Number, L: Tangent<T>>(law: &L, rho: Radius<T>, at: CosSin<T>, r: T) {
    let _context = context::<T, L>();
    let (p, log) = (
        law.point_density(rho, at, r),
        law.ln_point_density(rho, at, r),
    );
    if at.cos.nan() || at.sin.nan() || r.nan() {
        assert!(p.nan() && log.nan(), "NaN in, {p:?}, {log:?} out");
        return;
    }
    // A longer pair is no direction.
    if at.cos.wide().abs() > 1.0 || at.sin.wide().abs() > 1.0 {
        return;
    }
    assert!(
        !p.nan() && !log.nan(),
        "{p:?}, {log:?} at {at:?}, r = {r:?}"
    );
    assert_positive_or_zero(p, "point_density");
    let reach = 2.0 * rho.get().wide() * at.cos.wide();
    let beyond = reads_r(L::MEASURE) && !(r.wide() >= 0.0 && r.wide() <= reach);
    // The law rounds 2ρ cos θ in its own format.
    let rounding = T::ULP * reach + T::LEAST_STEP;
    let decided = reach.is_finite() && (r.wide() - reach).abs() > rounding;
    let below = at.cos.wide() < 0.0 || (in_space(L::MEASURE) && at.sin.wide() < 0.0);
    if below || (beyond && decided) {
        assert_eq!([p, log].map(T::wide), [0.0, -f64::INFINITY], "outside");
    }
}

/// 2ρ cos θ times the root of v that the measure takes.
fn distance<T: Number, L: Tangent<T>>(law: &L, rho: Radius<T>, cos: T, v: T) {
    let _context = context::<T, L>();
    let probability = (0.0..=1.0).contains(&v.wide());
    if !probability || !(0.0..=1.0).contains(&cos.wide()) {
        return;
    }
    let share = match L::MEASURE {
        Measure::Area => v.wide().sqrt(),
        Measure::Volume => v.wide().cbrt(),
        _ => 1.0,
    };
    let got = law.distance(rho, CosSin { cos, sin: cos }, v);
    let want = 2.0 * rho.get().wide() * cos.wide() * share;
    assert_close::<T>(got.wide(), want, DISTANCE_ULP, "distance");
}

/// A point drawn in direction `at` lies where its density is positive.
fn drawn<T: Number, L: Tangent<T>>(law: &L, rho: Radius<T>, at: CosSin<T>, words: &mut Words) {
    let r = law.sample_distance(rho, at, words);
    let reach = rho.get() + rho.get();
    assert!(
        r.wide() >= 0.0 && r.wide() <= (reach * at.cos).wide(),
        "r = {r:?}, {rho:?}, {at:?}"
    );
    let (p, log) = (
        law.point_density(rho, at, r),
        law.ln_point_density(rho, at, r).wide(),
    );
    assert!(
        log.is_finite(),
        "ln_point_density is {log:?} at {rho:?}, {at:?}, r = {r:?}"
    );
    if (T::SMALLEST.wide()..f64::INFINITY).contains(&p.wide()) {
        let terms = 4.0 + 3.0 * rho.get().wide().ln().abs() + log.abs();
        let error = (log - p.wide().ln()).abs();
        assert!(
            error <= LN_ULP * T::ULP * terms,
            "ln p is {log:?}, p is {p:?}"
        );
    }
}

fn planar<T: Number, L: PlanarPoint<T>>(id: Id, law: &L, rho: Radius<T>, words: &Words) {
    let _context = context::<T, L>();
    let mut words = words.uncounted();
    let [x, y] = law.sample_point(rho, &mut words);
    assert_drawn::<T, L>(T::theta_words(id), words.drawn);
    assert_point(rho, [x.wide(), y.wide(), 0.0]);
    let [sin, cos] = coslobe::Planar::sample(law, &mut words);
    drawn(law, rho, CosSin { cos, sin }, &mut words);
}

fn spatial<T: Number, L: SpatialPoint<T>>(id: Id, law: &L, rho: Radius<T>, words: &Words) {
    let _context = context::<T, L>();
    let mut words = words.uncounted();
    let point = law.sample_point(rho, &mut words);
    assert_drawn::<T, L>(of_direction::<T>(id), words.drawn);
    assert_point(rho, point.map(T::wide));
    let at = law.warp_tails(coslobe::uniform::tails(&mut words));
    drawn(law, rho, at, &mut words);
}

fn assert_drawn<T: Number, L: Tangent<T>>(direction: Drawn, drawn: Drawn) {
    let distance = if reads_r(L::MEASURE) {
        T::TAIL_WORDS
    } else {
        (0, 0)
    };
    assert_eq!(
        drawn,
        (direction.0 + distance.0, direction.1 + distance.1),
        "words drawn"
    );
}

/// Finite, not below the horizon, and inside the ball of diameter 2ρ about (0, ρ, 0).
fn assert_point<T: Number>(rho: Radius<T>, [x, y, z]: [f64; 3]) {
    let diameter = 2.0 * rho.get().wide();
    assert!([x, y, z].iter().all(|c| c.is_finite()) && y >= 0.0);
    // r ≤ 2ρ cos θ is x² + y² + z² ≤ 2ρy. In parts of 2ρ, which over- and underflow nowhere.
    let [x, y, z] = [x, y, z].map(|c| c / diameter);
    let (square, slack) = (x * x + y * y + z * z, LENGTH_ULP * T::ULP * y);
    assert!(
        square <= y + slack + T::LEAST_STEP / T::SMALLEST.wide(),
        "({x:?}, {y:?}, {z:?})·2ρ lies outside"
    );
}
