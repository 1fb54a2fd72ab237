//! The sentences about each law.

use crate::args::LawName;
use plot::axis::superscript;

/// Title, density, what the point is uniform by, and caption.
pub(crate) fn of(name: LawName, k: f64) -> (&'static str, String, &'static str, String) {
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
