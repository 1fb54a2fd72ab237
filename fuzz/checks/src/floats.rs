//! The laws in floats: the input chooses an operation, a number type and a law, and one promise of
//! theirs is checked.
//!
//! - `judged`: results lie within their cells of `docs/bounds.md` from `Precise` ones;
//! - `densities`, `quantiles`, `warps`: total functions, the same law from every side, right
//!   outside the support too;
//! - `samples`, `points`: a unit vector or point inside the open support with a positive finite
//!   density, from the documented number of words, the same bits by every way to draw it, whatever
//!   the generator;
//! - `cos_power`: valid exponents alone, finite moments, and the law's own type at its exponent;
//! - `frames`, `weights`: orthonormal axes and the way back; weights that sum to 1 and their
//!   limits.

use super::input::Input;
use super::{cos_power, densities, frames, judged, points, quantiles, samples, warps, weights};
use kit::catalogue::every_number;
use kit::{Number, NumberVisitor};

/// What is checked in every number type. Whoever adds an operation adds it here.
fn operations<T: Number>() -> [fn(Input); 12] {
    [
        densities::at_angle::<T>,
        densities::at_pair::<T>,
        quantiles::brackets::<T>,
        quantiles::order::<T>,
        quantiles::round_trips::<T>,
        warps::directions::<T>,
        warps::back::<T>,
        samples::draws::<T>,
        points::densities::<T>,
        points::draws::<T>,
        frames::frame::<T>,
        weights::heuristics::<T>,
    ]
}

pub fn check(data: &[u8]) {
    let input = Input::new(data);
    match input.operation(16) {
        0..3 => judged::check(input),
        3 => cos_power::check(input),
        _ => every_number(&mut Chosen(input.number_type(5), Some(input))),
    }
}

/// Counts number types down to the chosen one.
struct Chosen<'a>(usize, Option<Input<'a>>);

impl NumberVisitor for Chosen<'_> {
    fn number<T: Number>(&mut self) {
        if self.0 > 0 {
            self.0 -= 1;
        } else if let Some(input) = self.1.take() {
            operations::<T>()[input.operation(16) - 4](input);
        }
    }
}
