//! Arguments that calls are counted over: ends, tails and the middle of each domain.

use coslobe::CosSin;
use kit::Number;

/// Arguments of each kind.
pub(crate) const COUNT: usize = 16;

/// Distances of an angle from the nearer end, 0 or π/2.
pub(crate) const FROM_END: [f64; COUNT / 2] = [0.0, 1e-30, 1e-8, 1e-4, 0.02, 0.2, 0.5, 0.77];

/// Nearer tails, from numbers that are subnormal in `f32`.
pub(crate) const TAILS: [f64; COUNT / 2] = [0.0, 1e-40, 1e-20, 1e-7, 1e-3, 0.1, 0.3, 0.499];

/// From the axis and from the horizon; of both signs in the plane.
pub(crate) fn angles<T: Number>(planar: bool) -> [T; COUNT] {
    core::array::from_fn(|i| {
        let d = FROM_END[i / 2];
        let theta = T::of(if i % 2 == 0 {
            d
        } else {
            core::f64::consts::FRAC_PI_2 - d
        });
        // f32's π/2 lies beyond the true one.
        let theta = if theta > T::END { T::END } else { theta };
        if planar && i % 4 >= 2 { -theta } else { theta }
    })
}

/// Unit vectors at those angles.
pub(crate) fn pairs<T: Number>(planar: bool) -> [CosSin<T>; COUNT] {
    core::array::from_fn(|i| {
        let (s, c) = libm::sincos(FROM_END[i / 2]);
        let (cos, sin) = if i % 2 == 0 { (c, s) } else { (s, c) };
        let sin = if planar && i % 4 >= 2 { -sin } else { sin };
        CosSin {
            cos: T::of(cos),
            sin: T::of(sin),
        }
    })
}

/// From both ends.
pub(crate) fn probabilities<T: Number>() -> [T; COUNT] {
    core::array::from_fn(|i| {
        let p = TAILS[i / 2];
        T::of(if i % 2 == 0 { p } else { 1.0 - p })
    })
}

/// Points of the square: each probability as the cdf of θ, another one as the azimuth.
pub(crate) fn square<T: Number>() -> [[T; 2]; COUNT] {
    let p = probabilities();
    core::array::from_fn(|i| [p[i], p[COUNT - 1 - i]])
}
