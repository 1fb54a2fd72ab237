//! Points of the disk, circle, ball and sphere, at any radius.

use super::float::{Float, pair_at};
use super::input::Words;
use super::measure::{assert_positive_or_zero, context};
use super::samples::Drawn;
use coslobe::{
    Ball, CircleArc, CircleShell, CosSin, Disk, Fast, Lambert, Measure, PlanarPoint, Precise,
    Radius, RadiusError, SpatialPoint, SphereShell, Tangent,
};
use std::f64::consts::FRAC_PI_2;

/// ln_point_density against the logarithm of point_density, in ulp of its largest term: 3 ln ρ.
const LN_ULP: f64 = 8.0;
/// The point's own length against 2ρ cos θ, which it must not pass by more than rounding.
const LENGTH_ULP: f64 = 4.0;

/// Words: ρ; cos θ or θ; sin θ; r; then the generator.
pub fn check(data: &[u8]) {
    all::<f32>(Words::new(data));
    all::<f64>(Words::new(data));
    all::<Precise<f32>>(Words::new(data));
    all::<Precise<f64>>(Words::new(data));
    all::<Fast<f32>>(Words::new(data));
}

fn all<T: Float + Drawn>(mut words: Words) {
    let [bits, even] = T::both(words.word(), 0.0, 4.0);
    let (a, b, r) = (words.word(), words.word(), T::from_word(words.word()));
    let any = CosSin {
        cos: T::from_word(a),
        sin: T::from_word(b),
    };
    let unit = pair_at(FRAC_PI_2 * T::unit(a).wide());
    for rho in [bits, even].into_iter().filter_map(radius) {
        for at in [
            any,
            unit,
            CosSin {
                cos: unit.sin,
                sin: unit.cos,
            },
        ] {
            density(&Disk, rho, at, r);
            density(&CircleShell, rho, at, r);
            density(&CircleArc, rho, at, r);
            density(&Ball, rho, at, r);
            density(&SphereShell, rho, at, r);
            density(&Lambert, rho, at, r);
        }
        planar(&Disk, rho, &words);
        planar(&CircleShell, rho, &words);
        planar(&CircleArc, rho, &words);
        spatial(&Ball, rho, &words);
        spatial(&SphereShell, rho, &words);
        spatial(&Lambert, rho, &words);
    }
}

/// Radius::new takes exactly what it says.
fn radius<T: Float>(rho: T) -> Option<Radius<T>> {
    let x = rho.wide();
    let expected = if x.is_nan() {
        Err(RadiusError::NotANumber)
    } else if x < T::NORMAL {
        Err(RadiusError::TooSmall)
    } else if x > T::LARGEST / 4.0 {
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

fn density<T: Float, L: Tangent<T>>(law: &L, rho: Radius<T>, at: CosSin<T>, r: T) {
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
    let rounding = T::ULP * reach + T::SMALLEST;
    let decided = reach.is_finite() && (r.wide() - reach).abs() > rounding;
    let below = at.cos.wide() < 0.0 || (in_space(L::MEASURE) && at.sin.wide() < 0.0);
    if below || (beyond && decided) {
        assert_eq!([p, log].map(T::wide), [0.0, -f64::INFINITY], "outside");
    }
}

/// A point drawn in direction `at` lies where its density is positive.
fn drawn<T: Float, L: Tangent<T>>(law: &L, rho: Radius<T>, at: CosSin<T>, words: &mut Words) {
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
    if (T::NORMAL..f64::INFINITY).contains(&p.wide()) {
        let terms = 4.0 + 3.0 * rho.get().wide().ln().abs() + log.abs();
        let error = (log - p.wide().ln()).abs();
        assert!(
            error <= LN_ULP * T::ULP * terms,
            "ln p is {log:?}, p is {p:?}"
        );
    }
}

fn planar<T: Float + Drawn, L: PlanarPoint<T>>(law: &L, rho: Radius<T>, words: &Words) {
    let _context = context::<T, L>();
    let mut words = words.clone();
    words.drawn = [0; 2];
    let [x, y] = law.sample_point(rho, &mut words);
    assert_drawn::<T, L>(T::PLANAR, words.drawn);
    assert_point(rho, [x.wide(), y.wide(), 0.0]);
    let [sin, cos] = coslobe::Planar::sample(law, &mut words);
    drawn(law, rho, CosSin { cos, sin }, &mut words);
}

fn spatial<T: Float + Drawn, L: SpatialPoint<T>>(law: &L, rho: Radius<T>, words: &Words) {
    let _context = context::<T, L>();
    let mut words = words.clone();
    words.drawn = [0; 2];
    let point = law.sample_point(rho, &mut words);
    assert_drawn::<T, L>(T::SPATIAL, words.drawn);
    assert_point(rho, point.map(T::wide));
    let at = law.warp_tails(coslobe::uniform::tails(&mut words));
    drawn(law, rho, at, &mut words);
}

fn assert_drawn<T: Float + Drawn, L: Tangent<T>>(direction: [u32; 2], drawn: [u32; 2]) {
    let distance = if reads_r(L::MEASURE) { T::UNIT } else { [0; 2] };
    assert_eq!(
        drawn,
        [direction[0] + distance[0], direction[1] + distance[1]],
        "words drawn"
    );
}

/// Finite, not below the horizon, and inside the ball of diameter 2ρ about (0, ρ, 0).
fn assert_point<T: Float>(rho: Radius<T>, [x, y, z]: [f64; 3]) {
    let diameter = 2.0 * rho.get().wide();
    assert!([x, y, z].iter().all(|c| c.is_finite()) && y >= 0.0);
    // r ≤ 2ρ cos θ is x² + y² + z² ≤ 2ρy. In parts of 2ρ, which over- and underflow nowhere.
    let [x, y, z] = [x, y, z].map(|c| c / diameter);
    let (square, slack) = (x * x + y * y + z * z, LENGTH_ULP * T::ULP * y);
    assert!(
        square <= y + slack + T::SMALLEST / T::NORMAL,
        "({x:?}, {y:?}, {z:?})·2ρ lies outside"
    );
}
