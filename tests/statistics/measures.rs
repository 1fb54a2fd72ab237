//! Which law each measure of a point gives: raw points, drawn without the crate, normalised.
//!
//! The paper sets out to normalise points uniform on a surface, but its δ(r − 2ρ cos θ) measures a
//! shell of constant radial thickness. This shows both, and that no law passes for another.

use coslobe::integers::{Fixed16Planar, Fixed16Spatial, FixedPlanar, FixedRadius, FixedSpatial};
use coslobe::{Fixed, Fixed16, Measure, Radius};
use fixed::traits::FixedSigned;
use fixed::types::{I16F0, I16F16, I32F0};
use kit::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law, every_law, every_number};
use kit::stats::claim::Claim;
use kit::stats::measures::{from_centre, radius, raw_point};
use kit::stats::{chi2, ks, words};
use kit::{Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw, TangentLaw};
use rand_pcg::Pcg64;
use std::f64::consts::TAU;

const N: usize = 100_000;

/// cdf of θ at every sample's direction, by `claim`.
fn cdfs(claim: &Claim, points: &[[f64; 3]]) -> Vec<f64> {
    let cdf = |&point: &[f64; 3]| {
        let [x, y, z] = point.map(|c| c / radius(point));
        let sin = if claim.planar { x } else { x.hypot(z) };
        let (p, is_upper) = claim.tail(y, sin);
        if is_upper { 1.0 - p } else { p }
    };
    points.iter().map(cdf).collect()
}

/// The claims of all laws that have a point, with their measures.
#[derive(Default)]
struct Measures(Vec<(Measure, Claim)>);

impl LawVisitor<f64> for Measures {
    fn planar<L: PlanarLaw<f64>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        self.0.push((L::MEASURE, claim));
    }
    fn spatial<L: SpatialLaw<f64>>(&mut self, _: Id, _: L) {}
    fn tangent<L: TangentLaw<f64>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        self.0.push((L::MEASURE, claim));
    }
}

fn matrix(planar: bool) {
    let mut laws = Measures::default();
    every_law(&mut laws, &[]);
    laws.0.retain(|(_, claim)| claim.planar == planar);
    assert_eq!(laws.0.len(), 3);
    for (measure, _) in &laws.0 {
        let mut rng = words::pcg(&format!("{measure:?}"));
        let points: Vec<_> = (0..N).map(|_| raw_point(*measure, &mut rng)).collect();
        for (claimed, claim) in &laws.0 {
            let mut u = cdfs(claim, &points);
            let mut cells = [0; 64];
            u.iter()
                .for_each(|u| cells[((u * 64.0) as usize).min(63)] += 1);
            let p = ks::uniform(&mut u).max(chi2::uniform(&cells));
            println!("points by {measure:?}, law of {claimed:?}: p = {p:.1e}");
            if measure == claimed {
                assert!(
                    p > 1e-4,
                    "{measure:?} does not give {}: p = {p:e}",
                    claim.name
                );
            } else {
                assert!(p < 1e-9, "{measure:?} passes for {}: p = {p:e}", claim.name);
            }
        }
    }
}

#[test]
fn each_planar_measure_gives_its_law_alone() {
    matrix(true);
}

#[test]
fn each_spatial_measure_gives_its_law_alone() {
    matrix(false);
}

/// `sample_point` of every law at the smallest, an ordinary and the largest radius.
struct Points;

impl Points {
    fn check<T: Number>(
        name: &str,
        measure: Measure,
        draw: impl Fn(Radius<T>, &mut Pcg64) -> [T; 3],
    ) {
        let largest = T::LARGEST.into() * 0.25;
        for rho in [T::SMALLEST, T::of(1.0), T::of(largest)] {
            let radius = Radius::new(rho).expect("inside the documented range");
            let mut rng = words::pcg(name);
            let points: Vec<_> = (0..N)
                .map(|_| draw(radius, &mut rng).map(Into::into))
                .collect();
            let case = format!("{name} rho={rho:?}");
            assert!(
                points.iter().flatten().all(|c: &f64| c.is_finite()),
                "{case}"
            );
            // Coordinates beside the smallest number have no digits to test.
            if rho > T::SMALLEST {
                let unit = points.iter().map(|point| point.map(|c| c / rho.into()));
                // A point on the surface has the length of its direction twice.
                let slack = 2.0 * T::LENGTH;
                Self::uniform(&case, measure, slack, unit.map(from_centre).collect());
            }
        }
    }

    /// Points about the origin, which have to be uniform by `measure` in the unit body.
    fn uniform(case: &str, measure: Measure, slack: f64, points: Vec<[f64; 3]>) {
        let power = match measure {
            Measure::Area => 2,
            Measure::Volume => 3,
            _ => 0,
        };
        let accept = |what: &str, mut u: Vec<f64>| {
            let p = ks::uniform(&mut u);
            println!("{case}: {what} p = {p:.1e}");
            assert!(p > 1e-5, "{case}: {what} is not uniform, p = {p:e}");
        };
        if power == 0 {
            let worst = points
                .iter()
                .map(|&p| (radius(p) - 1.0).abs())
                .fold(0.0, f64::max);
            assert!(worst <= slack, "{case}: off the surface by {worst:e}");
        } else {
            let shares: Vec<_> = points.iter().map(|&p| radius(p).powi(power)).collect();
            assert!(
                shares.iter().all(|&u| u <= 1.0 + 3.0 * slack),
                "{case}: outside the body"
            );
            accept("radius", shares);
        }
        let turn = |a: f64, b: f64| (a.atan2(b) / TAU).rem_euclid(1.0);
        match measure {
            Measure::Area | Measure::ArcLength => {
                accept("angle", points.iter().map(|p| turn(p[1], p[0])).collect());
            }
            Measure::Volume | Measure::SurfaceArea => {
                accept(
                    "height",
                    points
                        .iter()
                        .map(|&p| (p[1] / radius(p) + 1.0) / 2.0)
                        .collect(),
                );
                accept("azimuth", points.iter().map(|p| turn(p[2], p[0])).collect());
            }
            // A shell is uniform along the ray, not along the curve: its direction is tested as a
            // law.
            _ => {}
        }
    }
}

impl<T: Number> LawVisitor<T> for Points {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        Self::check(&claim.name, L::MEASURE, |rho, rng| {
            let [x, y] = law.sample_point(rho, rng);
            [x, y, T::of(0.0)]
        });
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, _: L) {}
    fn tangent<L: TangentLaw<T>>(&mut self, id: Id, law: L) {
        let claim = Claim::of(id, &law);
        Self::check(&claim.name, L::MEASURE, |rho, rng| {
            law.sample_point(rho, rng)
        });
    }
}

impl NumberVisitor for Points {
    fn number<T: Number>(&mut self) {
        every_law::<T>(self, &[]);
    }
}

#[test]
fn points_are_uniform() {
    every_number(&mut Points);
}

/// In integers: of 32 bits at radii of two magnitudes, of 16 bits at the largest.
struct InIntegers;

impl InIntegers {
    fn check<const N: usize, D: FixedSigned>(
        name: &str,
        measure: Measure,
        rho: D,
        draw: impl Fn(FixedRadius<D>, &mut Pcg64) -> [D; N],
    ) {
        let radius = FixedRadius::new(rho).expect("a radius");
        let rho: f64 = rho.to_num();
        let case = format!("{name} of {} bits, rho={rho}", 8 * size_of::<D>());
        let mut rng = words::pcg(&case);
        let mut point = || {
            let mut all = [0.0; 3];
            let point = draw(radius, &mut rng);
            all.iter_mut()
                .zip(point)
                .for_each(|(to, from)| *to = from.to_num::<f64>() / rho);
            from_centre(all)
        };
        let points = (0..N_POINTS).map(|_| point()).collect();
        // A unit or two of the coordinates, and of the direction.
        let unit = D::DELTA.to_num::<f64>() / rho;
        Points::uniform(&case, measure, 4.0 * unit, points);
    }
}

const N_POINTS: usize = N / 4; // more would see a grid of 16 bits

impl IntegerVisitor for InIntegers {
    fn law<L: IntegerLaw>(&mut self, _: L) {}
    fn planar<L: IntegerLaw + FixedPlanar + Fixed16Planar>(&mut self, law: L) {
        let (long, short) = (Fixed(law), Fixed16(law));
        let (name, measure) = (L::ID.name(), Fixed::<L>::MEASURE);
        let (millimetres, units) = (I16F16::from_num(100), I32F0::from_num(1 << 28));
        Self::check(name, measure, millimetres, |rho, rng| {
            long.sample_point(rho, rng)
        });
        Self::check(name, measure, units, |rho, rng| long.sample_point(rho, rng));
        let short_units = I16F0::from_num(8_000);
        Self::check(name, measure, short_units, |rho, rng| {
            short.sample_point(rho, rng)
        });
    }
    fn spatial<L: IntegerLaw + FixedSpatial + Fixed16Spatial>(&mut self, law: L) {
        let (long, short) = (Fixed(law), Fixed16(law));
        let (name, measure) = (L::ID.name(), Fixed::<L>::MEASURE);
        let (millimetres, units) = (I16F16::from_num(100), I32F0::from_num(1 << 28));
        Self::check(name, measure, millimetres, |rho, rng| {
            long.sample_point(rho, rng)
        });
        Self::check(name, measure, units, |rho, rng| long.sample_point(rho, rng));
        let short_units = I16F0::from_num(8_000);
        Self::check(name, measure, short_units, |rho, rng| {
            short.sample_point(rho, rng)
        });
    }
}

#[test]
fn points_in_integers_are_uniform() {
    every_integer_law(&mut InIntegers);
}
