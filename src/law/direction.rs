//! A direction's three components, rounded once: the product of two rounded numbers is no longer
//! one.

use crate::arithmetic::holds::Holds;
use crate::arithmetic::kernel::{Kernel, Wide};
use crate::number::Real;
use crate::number::tier::{Code, Margin, Tier};
use crate::scalar::Scalar;
use crate::{CosSin, Tails};

/// An azimuth by what it is given as, for either phase of a number type.
#[derive(Clone, Copy)]
pub enum Azimuth<T: Real> {
    /// Random bits.
    Word(<T as Tier>::TurnBits),
    /// Turns in \[0, 1\]; beside NaN tails any number.
    Turn(T),
}

impl<T: Real> Azimuth<T> {
    /// By what loops of vectors need: in space a conversion is no quicker for one sample.
    #[inline(always)]
    pub(crate) fn quick(self) -> CosSin<T::Quick> {
        match self {
            Azimuth::Word(bits) => T::quick_turn_from_bits(bits, Code::Vector),
            Azimuth::Turn(turn) => Kernel::at_turn(Holds::from_number(turn)),
        }
    }

    #[inline(always)]
    pub(crate) fn accurate(self) -> CosSin<T::Accurate> {
        match self {
            Azimuth::Word(bits) => T::accurate_turn_from_bits(bits, Code::Vector),
            Azimuth::Turn(turn) => Kernel::at_turn(Holds::from_number(turn)),
        }
    }

    /// Its cosine and sine, each rounded once.
    #[inline(always)]
    pub(crate) fn rounded(self) -> CosSin<T> {
        CosSin::from_array(T::rounded(
            Margin::Relative,
            #[inline(always)]
            || self.quick().to_array(),
            #[inline(always)]
            || self.accurate().to_array(),
        ))
    }
}

/// \[sin θ cos φ, cos θ, sin θ sin φ\].
#[inline(always)]
pub(crate) fn spherical<T: Scalar>(at: CosSin<T>, azimuth: CosSin<T>) -> [T; 3] {
    [at.sin * azimuth.cos, at.cos, at.sin * azimuth.sin]
}

/// The direction with cos²θ = the upper of the tails p, rounded once.
#[inline(always)]
pub(crate) fn at_square<T: Real>(p: Tails<T>, azimuth: Azimuth<T>) -> [T; 3] {
    T::rounded(
        Margin::Relative,
        #[inline(always)]
        || spherical(T::Quick::square_warp(Holds::from_tails(p)), azimuth.quick()),
        #[inline(always)]
        || {
            spherical(
                T::Accurate::square_warp(Holds::from_tails(p)),
                azimuth.accurate(),
            )
        },
    )
}

/// Its (cos θ, sin θ), rounded once.
#[inline(always)]
pub(crate) fn angle_at_square<T: Real>(p: Tails<T>) -> CosSin<T> {
    CosSin::from_array(T::rounded(
        Margin::Relative,
        #[inline(always)]
        || T::Quick::square_warp(Holds::from_tails(p)).to_array(),
        #[inline(always)]
        || T::Accurate::square_warp(Holds::from_tails(p)).to_array(),
    ))
}

/// (cos θ, sin θ) of a direction, and its azimuth in turns, from 0 to 1.
#[inline(always)]
pub(crate) fn polar<T: Real, W: Holds<T>>(d: [T; 3]) -> (CosSin<W>, W) {
    let [x, cos, z] = d.map(W::from_number);
    let sin = CosSin::hypot(x, z);
    let turn = z.atan2(x) * W::CONSTANTS.recip_two_pi.value();
    let turn = if turn < W::ZERO { turn + W::ONE } else { turn };
    (W::by_the_smaller(CosSin { cos, sin }), turn)
}

/// The azimuth of a direction in turns, rounded once.
#[inline]
pub(crate) fn turn<T: Real>(d: [T; 3]) -> T {
    let [turn] = T::rounded(
        Margin::Unbounded,
        #[inline(always)]
        || [polar::<T, T::Quick>(d).1],
        || [polar::<T, T::Accurate>(d).1],
    );
    turn
}

/// The angle θ of (cos θ, sin θ), rounded once.
#[inline(always)]
pub(crate) fn angle<T: Real>(at: CosSin<T>) -> T {
    let [theta] = T::rounded(
        Margin::Relative,
        #[inline(always)]
        || [T::Quick::angle(Holds::from_components(at))],
        || [T::Accurate::angle(Holds::from_components(at))],
    );
    theta
}
