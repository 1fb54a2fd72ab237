//! Arguments: few and stratified for the cost, many for the errors.

use super::cell::{Inputs, generator};
use crate::accuracy::format::Format;
use crate::accuracy::inputs::stratified;
use coslobe::CosSin;
use coslobe::rand_core::Rng;

/// Arguments that instructions are counted over, and that time is taken over.
const COUNTED: u64 = 510;
const TIMED: u64 = 8192;

/// Angles: a third by decade, a third evenly, a third crowding at π/2; of both signs in the plane.
pub fn angles<T: Format>(planar: bool) -> Inputs<T> {
    let sign = |i, angle: T| if planar && i % 2 == 1 { -angle } else { angle };
    let half_pi = T::of_bits(T::TOP_ANGLE).wide();
    Inputs {
        counted: (0..COUNTED)
            .map(|i| sign(i, stratified::<T>(T::TOP_ANGLE, i, COUNTED)))
            .collect(),
        timed: even().map(|(i, x)| sign(i, T::of(half_pi * x))).collect(),
    }
}

/// Unit vectors at those angles.
pub fn pairs<T: Format>(planar: bool) -> Inputs<CosSin<T>> {
    let pair = |&theta: &T| {
        let (sin, cos) = theta.wide().sin_cos();
        CosSin {
            cos: T::of(cos),
            sin: T::of(sin),
        }
    };
    let Inputs { counted, timed } = angles::<T>(planar);
    Inputs {
        counted: counted.iter().map(pair).collect(),
        timed: timed.iter().map(pair).collect(),
    }
}

/// Probabilities, those to count over crowding at both ends.
pub fn probabilities<T: Format>() -> Inputs<T> {
    let p = |i| stratified::<T>(T::HALF_BITS, i, COUNTED);
    let mirrored = |i| T::of(1.0) - p(i);
    Inputs {
        counted: (0..COUNTED)
            .map(|i| if i % 2 == 1 { mirrored(i) } else { p(i) })
            .collect(),
        timed: even().map(|(_, x)| T::of(x)).collect(),
    }
}

/// Indices with numbers in (0, 1), uniform and in no order.
fn even() -> impl Iterator<Item = (u64, f64)> {
    let mut rng = generator();
    (0..TIMED).map(move |i| (i, (f64::from(rng.next_u32()) + 0.5) * 2f64.powi(-32)))
}

/// Which uniforms errors are measured at.
#[derive(Clone, Copy, Debug)]
pub enum Uniforms {
    /// Every normal number of the format up to ½, by decade, and their mirror images.
    All,
    /// Multiples of 2⁻²⁴ (`f32`) or 2⁻⁵³ (`f64`): what `rand` draws.
    Grid,
    /// Down to 2⁻ⁿ⁻¹: what this crate makes of n random bits.
    Down(i32),
}

/// p in (0, ½], n in each octave.
pub fn tails<T: Format>(from: Uniforms, n: u32) -> Vec<T> {
    let octaves = match from {
        Uniforms::All => -T::LEAST - 1,
        Uniforms::Grid => T::DIGITS - 1,
        Uniforms::Down(bits) => bits,
    };
    let grid = 2f64.powi(T::DIGITS);
    let mut tails = vec![T::of(0.5)];
    for octave in 1..=octaves {
        for j in 0..n {
            // The golden ratio's multiples spread evenly without a pattern.
            let share = (f64::from(j) * 0.618_033_988_749_894_9).fract();
            let p = 2f64.powi(-octave - 1) * (1.0 + share);
            tails.push(T::of(match from {
                Uniforms::Grid => (p * grid).round() / grid,
                _ => p,
            }));
        }
    }
    tails
}
