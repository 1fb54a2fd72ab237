//! Both fixed-point types by one trait.

use crate::Operations;
use coslobe::fixed::FixedLaw;
use coslobe::fixed16::Fixed16Law;
use coslobe::rand_core::Rng;
use coslobe::{CosSin, Fixed, Fixed16};
use fixed::types::{I0F16, I0F32, I1F15, I1F31, U0F16, U0F32};

impl<L: FixedLaw> Operations for Fixed<L> {
    type Component = I1F31;
    type Probability = U0F32;
    type Turn = I0F32;
    type Density = L::Density;
    type Direction = L::Direction;

    #[inline(always)]
    fn warp(&self, u: Self::Probability) -> CosSin<Self::Component> {
        Fixed::warp(self, u)
    }

    #[inline(always)]
    fn warp_sf(&self, q: Self::Probability) -> CosSin<Self::Component> {
        Fixed::warp_sf(self, q)
    }

    #[inline(always)]
    fn quantile(&self, p: Self::Probability) -> Self::Turn {
        Fixed::quantile(self, p)
    }

    #[inline(always)]
    fn isf(&self, p: Self::Probability) -> Self::Turn {
        Fixed::isf(self, p)
    }

    #[inline(always)]
    fn cdf(&self, theta: Self::Turn) -> Self::Probability {
        Fixed::cdf(self, theta)
    }

    #[inline(always)]
    fn sf(&self, theta: Self::Turn) -> Self::Probability {
        Fixed::sf(self, theta)
    }

    #[inline(always)]
    fn pdf(&self, theta: Self::Turn) -> L::Density {
        Fixed::pdf(self, theta)
    }

    #[inline(always)]
    fn density(&self, at: CosSin<Self::Component>) -> L::Density {
        Fixed::density(self, at)
    }

    #[inline(always)]
    fn unwarp(&self, at: CosSin<Self::Component>) -> Self::Probability {
        Fixed::unwarp(self, at)
    }

    #[inline(always)]
    fn unwarp_sf(&self, at: CosSin<Self::Component>) -> Self::Probability {
        Fixed::unwarp_sf(self, at)
    }

    #[inline(always)]
    fn sample<R: Rng>(&self, rng: &mut R) -> L::Direction {
        Fixed::sample(self, rng)
    }
}

impl<L: Fixed16Law> Operations for Fixed16<L> {
    type Component = I1F15;
    type Probability = U0F16;
    type Turn = I0F16;
    type Density = L::Density;
    type Direction = L::Direction;

    #[inline(always)]
    fn warp(&self, u: Self::Probability) -> CosSin<Self::Component> {
        Fixed16::warp(self, u)
    }

    #[inline(always)]
    fn warp_sf(&self, q: Self::Probability) -> CosSin<Self::Component> {
        Fixed16::warp_sf(self, q)
    }

    #[inline(always)]
    fn quantile(&self, p: Self::Probability) -> Self::Turn {
        Fixed16::quantile(self, p)
    }

    #[inline(always)]
    fn isf(&self, p: Self::Probability) -> Self::Turn {
        Fixed16::isf(self, p)
    }

    #[inline(always)]
    fn cdf(&self, theta: Self::Turn) -> Self::Probability {
        Fixed16::cdf(self, theta)
    }

    #[inline(always)]
    fn sf(&self, theta: Self::Turn) -> Self::Probability {
        Fixed16::sf(self, theta)
    }

    #[inline(always)]
    fn pdf(&self, theta: Self::Turn) -> L::Density {
        Fixed16::pdf(self, theta)
    }

    #[inline(always)]
    fn density(&self, at: CosSin<Self::Component>) -> L::Density {
        Fixed16::density(self, at)
    }

    #[inline(always)]
    fn unwarp(&self, at: CosSin<Self::Component>) -> Self::Probability {
        Fixed16::unwarp(self, at)
    }

    #[inline(always)]
    fn unwarp_sf(&self, at: CosSin<Self::Component>) -> Self::Probability {
        Fixed16::unwarp_sf(self, at)
    }

    #[inline(always)]
    fn sample<R: Rng>(&self, rng: &mut R) -> L::Direction {
        Fixed16::sample(self, rng)
    }
}
