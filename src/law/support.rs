//! The laws' support, and what a value is outside it.

use crate::scalar::Scalar;
use crate::{CosSin, Tails};

/// `value` where `inside`, `outside` elsewhere, and NaN where `x` is NaN.
#[inline(always)]
pub(crate) fn within<T: Scalar>(x: T, inside: bool, value: T, outside: T) -> T {
    if x.is_nan() {
        x
    } else if inside {
        value
    } else {
        outside
    }
}

/// `value` of a power where 0 ≤ θ ≤ π/2, `outside` elsewhere, and NaN where θ is NaN. No branch:
/// around so many operations it would keep a loop over slices from vectors.
#[inline(always)]
pub(crate) fn spatial_power<T: Scalar>(theta: T, value: T, outside: T) -> T {
    let inside = (theta >= T::ZERO) & (theta <= T::HALF_PI_DOWN);
    let value = T::select(inside, value, outside);
    T::select(theta.is_nan(), theta, value)
}

/// The angle, or the last number inside the support if rounding put it beyond ±π/2.
#[inline(always)]
pub(crate) fn into_support<T: Scalar>(theta: T) -> T {
    if theta > T::HALF_PI_DOWN {
        T::HALF_PI_DOWN
    } else if theta < -T::HALF_PI_DOWN {
        -T::HALF_PI_DOWN
    } else {
        theta
    }
}

/// −π/2 ≤ θ ≤ π/2, with the true π.
#[inline(always)]
pub(crate) fn planar<T: Scalar>(theta: T) -> bool {
    theta.abs() <= T::HALF_PI_DOWN
}

/// 0 ≤ θ ≤ π/2, with the true π.
#[inline(always)]
pub(crate) fn spatial<T: Scalar>(theta: T) -> bool {
    theta >= T::ZERO && theta <= T::HALF_PI_DOWN
}

/// `value` for a direction with cos θ ≥ 0, 0 below the horizon, NaN where a component is.
#[inline(always)]
pub(crate) fn planar_direction<T: Scalar>(at: CosSin<T>, value: T) -> T {
    direction(at, at.cos >= T::ZERO, value)
}

/// `value` for a direction with cos θ, sin θ ≥ 0, 0 elsewhere, NaN where a component is.
#[inline(always)]
pub(crate) fn spatial_direction<T: Scalar>(at: CosSin<T>, value: T) -> T {
    direction(at, at.cos >= T::ZERO && at.sin >= T::ZERO, value)
}

/// As [`spatial_direction`], of a power, with no branch.
#[inline(always)]
pub(crate) fn spatial_direction_power<T: Scalar>(at: CosSin<T>, value: T) -> T {
    let inside = (at.cos >= T::ZERO) & (at.sin >= T::ZERO);
    let value = T::select(inside, value + T::ZERO, T::ZERO);
    let value = T::select(at.sin.is_nan(), at.sin, value);
    T::select(at.cos.is_nan(), at.cos, value)
}

#[inline(always)]
fn direction<T: Scalar>(at: CosSin<T>, inside: bool, value: T) -> T {
    // + 0 turns the −0 of a cosine −0 into +0.
    let value = within(at.sin, inside, value + T::ZERO, T::ZERO);
    within(at.cos, true, value, value)
}

/// The tails of a spatial law at θ: `inside`, or those of the end that θ lies beyond.
#[inline(always)]
pub(crate) fn spatial_tails<T: Scalar>(theta: T, inside: Tails<T>) -> Tails<T> {
    if spatial(theta) {
        inside
    } else {
        Tails::from_nearer(within(theta, true, T::ZERO, T::ZERO), theta > T::ZERO)
    }
}

/// The tails of a spatial law at a direction: `inside`, or those of the end that it lies beyond.
#[inline(always)]
pub(crate) fn spatial_direction_tails<T: Scalar>(at: CosSin<T>, inside: Tails<T>) -> Tails<T> {
    if at.cos >= T::ZERO && at.sin >= T::ZERO {
        inside
    } else {
        Tails::from_nearer(direction(at, true, T::ZERO), at.cos < T::ZERO)
    }
}
