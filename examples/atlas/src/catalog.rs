//! The laws of the atlas: their words, their mathematics, and the crate's code for them.

use crate::args::LawName;
use crate::number::Number;
use crate::random::Counter;
use crate::reference::Shape;
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, CosSin, Disk, ExponentError, Lambert, Moments, Planar,
    PlanarPoint, Radius, RadiusError, Real, Spatial, SpatialPoint, SphereShell,
};
use rand_pcg::Pcg64;
use std::error::Error;
use std::f64::consts::TAU;

/// What the atlas asks of a law in one number type.
pub(crate) trait Probe<T>: Sync {
    fn draw(&self, rng: &mut Counter) -> CosSin<f64>;
    /// cos θ where the tail of the horizon is p.
    fn cos_at(&self, p: T) -> T;
    /// Density of θ alone, per radian.
    fn marginal(&self, theta: T) -> f64;
    /// Density of the direction: per radian in the plane, per steradian in space.
    fn lobe(&self, theta: T) -> T;
    fn moments(&self) -> Moments<T>;
}

struct Flat<L>(L);
struct Solid<L>(L);

impl<T: Number, L: Planar<T> + Sync> Probe<T> for Flat<L> {
    fn draw(&self, rng: &mut Counter) -> CosSin<f64> {
        let [sin, cos] = self.0.sample(rng).map(Into::into);
        CosSin { cos, sin }
    }

    fn cos_at(&self, p: T) -> T {
        self.0.warp(p).cos
    }

    fn marginal(&self, theta: T) -> f64 {
        self.0.pdf(theta).into()
    }

    fn lobe(&self, theta: T) -> T {
        self.0.pdf(theta)
    }

    fn moments(&self) -> Moments<T> {
        self.0.moments()
    }
}

impl<T: Number, L: Spatial<T> + Sync> Probe<T> for Solid<L> {
    fn draw(&self, rng: &mut Counter) -> CosSin<f64> {
        let [x, cos, z] = self.0.sample(rng).map(Into::into);
        let sin = f64::hypot(x, z);
        CosSin { cos, sin }
    }

    fn cos_at(&self, p: T) -> T {
        self.0.warp_sf(p).cos
    }

    fn marginal(&self, theta: T) -> f64 {
        TAU * self.0.pdf(theta).into()
    }

    fn lobe(&self, theta: T) -> T {
        self.0.pdf_solid_angle(theta)
    }

    fn moments(&self) -> Moments<T> {
        self.0.moments()
    }
}

/// Draws x and y of a point before it was normalised.
type DrawPoint = Box<dyn Fn(&mut Pcg64) -> [f64; 2]>;

/// One number type's side of a law.
pub(crate) struct Side<T> {
    pub(crate) probe: Box<dyn Probe<T>>,
    pub(crate) shape: Shape,
}

/// A law with everything the atlas shows of it.
pub(crate) struct Entry {
    pub(crate) name: LawName,
    pub(crate) title: &'static str,
    /// Density, per steradian or radian.
    pub(crate) formula: String,
    pub(crate) unit: &'static str,
    pub(crate) measure: &'static str,
    pub(crate) caption: String,
    pub(crate) spatial: bool,
    pub(crate) single: Side<f32>,
    pub(crate) double: Side<f64>,
    pub(crate) point: Option<DrawPoint>,
}

/// The crate's side of a law.
struct Code(Side<f32>, Side<f64>, Option<DrawPoint>);

fn side<T>(probe: impl Probe<T> + 'static, shape: Shape) -> Side<T> {
    Side {
        probe: Box::new(probe),
        shape,
    }
}

/// The tangent disks and balls have diameter 1, as the lobes have r(0) = 1.
fn radius<T: Real + Number>() -> Result<Radius<T>, RadiusError> {
    Radius::new(T::of(0.5))
}

fn planar<L>(law: L, shape: Shape) -> Result<Code, RadiusError>
where
    L: Planar<f32> + PlanarPoint<f64> + Copy + Sync + 'static,
{
    let rho = radius()?;
    let point: DrawPoint = Box::new(move |rng| law.sample_point(rho, rng));
    Ok(Code(
        side(Flat(law), shape),
        side(Flat(law), shape),
        Some(point),
    ))
}

fn spatial<L>(law: L, k: f64) -> Result<Code, RadiusError>
where
    L: Spatial<f32> + SpatialPoint<f64> + Copy + Sync + 'static,
{
    let rho = radius()?;
    let point: DrawPoint = Box::new(move |rng| {
        let [x, y, _] = law.sample_point(rho, rng);
        [x, y]
    });
    let shape = Shape::Power(k);
    Ok(Code(
        side(Solid(law), shape),
        side(Solid(law), shape),
        Some(point),
    ))
}

fn power_side<T: Number>(k: f64) -> Result<Side<T>, ExponentError> {
    let k = T::of(k);
    Ok(side(Solid(CosPower::new(k)?), Shape::Power(k.into())))
}

fn power(k: f64) -> Result<Code, String> {
    let fail = |format, e: ExponentError| format!("--exponent {k} as {format}: {e}");
    let double = power_side(k).map_err(|e| fail("f64", e))?;
    let single = power_side(k).map_err(|e| fail("f32", e))?;
    Ok(Code(single, double, None))
}

/// Checked whatever laws are asked for, so that a bad exponent never passes unseen.
pub(crate) fn check_exponent(k: f64) -> Result<(), String> {
    power(k).map(|_| ())
}

impl Entry {
    pub(crate) fn new(name: LawName, k: f64) -> Result<Entry, Box<dyn Error>> {
        let code = match name {
            LawName::Disk => planar(Disk, Shape::Disk)?,
            LawName::CircleShell => planar(CircleShell, Shape::CircleShell)?,
            LawName::CircleArc => planar(CircleArc, Shape::CircleArc)?,
            LawName::Ball => spatial(Ball, 3.0)?,
            LawName::SphereShell => spatial(SphereShell, 2.0)?,
            LawName::Lambert => spatial(Lambert, 1.0)?,
            LawName::CosPower => power(k)?,
        };
        let (title, formula, measure, caption) = crate::words::of(name, k);
        let spatial = name >= LawName::Ball;
        let Code(single, double, point) = code;
        Ok(Entry {
            name,
            title,
            formula,
            unit: if spatial { "sr⁻¹" } else { "rad⁻¹" },
            measure,
            caption,
            spatial,
            single,
            double,
            point,
        })
    }
}
