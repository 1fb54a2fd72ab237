//! Errors of the peers, by the code that the boards count.

use kit::accuracy::reference::{self, Direction, Id};
use kit::formulas::{Libm, Maths, Micromath, Plane, Space};
use kit::study::errors::{Errors, azimuth, of_angle, of_map, of_quantile};
use kit::study::inputs::{Uniforms, angles};

/// Uniforms in each octave that an error is the worst of, as in `tools/accuracy_cost`.
const PER_OCTAVE: u32 = 64;

/// The largest relative error of a peer's operation; of a `sample` that of (cos θ, sin θ).
pub(crate) fn error(binary: &str, law: &str, operation: &str) -> Option<f64> {
    let errors = match binary {
        "libm" => of::<Libm>(law, operation),
        "micromath" => of::<Micromath>(law, operation),
        _ => None,
    };
    errors.map(|e| e.worst())
}

fn of<M: Maths + 'static>(law: &str, operation: &str) -> Option<Errors> {
    let id = Id::parse(law)?;
    match (Plane::of(id), Space::of(id)) {
        (Some(law), _) => in_plane::<M>(law, id, operation),
        (_, law) => in_space::<M>(law?, id, operation),
    }
}

fn in_plane<M: Maths + 'static>(law: Plane, id: Id, operation: &str) -> Option<Errors> {
    Some(match operation {
        // Of two uniforms: no map of one tail.
        "sample" | "quantile" if law == Plane::Disk => return None,
        "sample" => of_map::<f32, 2>(id, false, Uniforms::Grid, PER_OCTAVE, |u| {
            law.direction::<M>(u, || 0.0)
        }),
        "quantile" => {
            of_quantile::<f32>(id, PER_OCTAVE, |p| law.quantile::<M>(p).unwrap_or(f32::NAN))
        }
        "pdf" => pdf(id, |x| law.pdf::<M>(x)),
        "cdf" => cdf(id, |x| law.cdf::<M>(x)),
        _ => return None,
    })
}

fn in_space<M: Maths + 'static>(law: Space, id: Id, operation: &str) -> Option<Errors> {
    Some(match operation {
        "sample" => of_map::<f32, 3>(id, true, Uniforms::Grid, PER_OCTAVE, |u| {
            law.direction::<M>(u, azimuth(u))
        }),
        "quantile" => of_quantile::<f32>(id, PER_OCTAVE, |p| law.quantile::<M>(p)),
        "pdf" => pdf(id, |x| law.pdf::<M>(x)),
        "cdf" => cdf(id, |x| law.cdf::<M>(x)),
        _ => return None,
    })
}

fn pdf(id: Id, f: impl Fn(f32) -> f32) -> Errors {
    let inputs = angles::<f32>(id.planar());
    of_angle(&inputs.counted, f, |theta| {
        reference::pdf(id, &Direction::at_angle(theta.abs()))
    })
}

fn cdf(id: Id, f: impl Fn(f32) -> f32) -> Errors {
    let inputs = angles::<f32>(id.planar());
    of_angle(&inputs.counted, f, |theta| {
        let (lower, upper) = reference::tails(id, &Direction::at_angle(theta.abs()));
        // A planar law's tails are those at −|θ|.
        if id.planar() && theta > 0.0 {
            upper
        } else {
            lower
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_peers_err_as_their_kind_does() {
        let sample = |binary, law| error(binary, law, "sample").unwrap();
        assert!(sample("libm", "Lambert") < 1e-6);
        let micromath = sample("micromath", "Lambert");
        assert!((1e-3..1.0).contains(&micromath), "{micromath}");
        assert_eq!(error("libm", "Disk", "sample"), None);
    }
}
