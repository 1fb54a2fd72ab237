//! The laws of the atlas: their words, their mathematics, and the crate's code for them.

use crate::number::Number;
use crate::probe::{Flat, Side, Solid, side};
use crate::reference::Shape;
use clap::ValueEnum;
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, Disk, ExponentError, Lambert, Planar, PlanarPoint,
    Radius, RadiusError, Real, Spatial, SpatialPoint, SphereShell,
};
use plot::axis::superscript;
use rand_pcg::Pcg64;
use std::error::Error;

/// A law, as the command line and the file names call it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, ValueEnum)]
pub(crate) enum LawName {
    Disk,
    CircleShell,
    CircleArc,
    Ball,
    SphereShell,
    #[value(alias = "sphere-area")]
    Lambert,
    CosPower,
}

impl LawName {
    /// Its figure's file, and its emblem's.
    pub(crate) fn files(self) -> [String; 2] {
        [".svg", "-small.svg"].map(|end| self.slug() + end)
    }

    /// The command line's spelling.
    pub(crate) fn slug(self) -> String {
        self.to_possible_value()
            .map_or_else(String::new, |value| value.get_name().to_owned())
    }
}

/// Draws x and y of a point before it was normalised.
type DrawPoint = Box<dyn Fn(&mut Pcg64) -> [f64; 2]>;

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
        let (title, formula, measure, caption) = words(name, k);
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

/// Title, density, what the point is uniform by, and caption.
fn words(name: LawName, k: f64) -> (&'static str, String, &'static str, String) {
    let (title, formula, measure, caption) = match name {
        LawName::Disk => (
            "Disk",
            "2 cos²θ / π",
            "area of the disk",
            "A point uniform by area in a disk that touches the origin, seen from the origin; \
             sin θ follows Wigner’s semicircle, and the inverse is Kepler’s equation at eccentricity 1.",
        ),
        LawName::CircleShell => (
            "CircleShell",
            "cos θ / 2",
            "radial shell on the circle",
            "A shell of constant thickness along the ray, which is thinner across the curve where the \
             ray grazes it; measured by arc length instead, the cosine cancels and CircleArc is left.",
        ),
        LawName::CircleArc => (
            "CircleArc",
            "1 / π",
            "arc length of the circle",
            "A point uniform by arc length: by the inscribed-angle theorem equal arcs are seen under \
             equal angles, so the direction is uniform; CircleShell is its radial twin.",
        ),
        LawName::Ball => (
            "Ball",
            "2 cos³θ / π",
            "volume of the ball",
            "A point uniform by volume in a ball that touches the origin, seen from the origin; \
             the picture is the projection of its points on the x-y plane.",
        ),
        LawName::SphereShell => (
            "SphereShell",
            "3 cos²θ / 2π",
            "radial shell on the sphere",
            "A shell of constant thickness along the ray: mean cos θ is ¾; measured by surface area \
             instead, one cosine cancels, the mean is ⅔ and the law is Lambert’s.",
        ),
        LawName::Lambert => (
            "Lambert = SphereArea",
            "cos θ / π",
            "area of the sphere",
            "A point uniform by area on a sphere that touches the origin: Lambert’s law, whose lobe is \
             that sphere itself; SphereShell is its radial twin.",
        ),
        LawName::CosPower => {
            let caption = format!(
                "The Phong lobe of exponent k = {k}: no tangent ball has it, but k = 1, 2, 3 are \
                 Lambert, SphereShell and Ball."
            );
            let formula = if k.fract() == 0.0 && k < 1000.0 {
                format!("{} cos{}θ / 2π", k + 1.0, superscript(k.abs()))
            } else {
                "(k+1) cosᵏθ / 2π".to_owned()
            };
            return ("CosPower", formula, "direction alone", caption);
        }
    };
    (title, formula.to_owned(), measure, caption.to_owned())
}
