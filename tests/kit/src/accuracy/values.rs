//! Number types over a raw format, and the values of a law in one of them.

use super::op::{AT_ANGLE, AT_TAIL};
use crate::Number;
use coslobe::{CosSin, Law};
use std::marker::PhantomData;

/// All values of a law at an input in one call, so that the compiler may share work among them.
pub trait Values<F>: Send + Sync {
    /// In the order of [`AT_ANGLE`]; 0 for what the law has not, and of θ where there is none.
    fn at_angle(&self, theta: Option<F>, pair: CosSin<F>) -> [F; AT_ANGLE.len()];
    /// In the order of [`AT_TAIL`].
    fn at_tail(&self, p: F) -> [F; AT_TAIL.len()];
    fn quantile(&self, p: F) -> F;
    fn isf(&self, p: F) -> F;
    /// The same over a block, `out[slot][i]`.
    fn angles(&self, theta: Option<&[F]>, pairs: &[CosSin<F>], out: &mut [Vec<F>]);
    fn tails(&self, p: &[F], out: &mut [Vec<F>]);
}

/// A law in the number type T.
pub struct On<T, L, S> {
    law: L,
    solid: S,
    planar: bool,
    number: PhantomData<fn() -> T>,
}

impl<T, L, S> On<T, L, S> {
    /// `solid` is its density per steradian, read for spatial laws alone; `planar` if at −θ too.
    pub fn new(law: L, solid: S, planar: bool) -> Self {
        On {
            law,
            solid,
            planar,
            number: PhantomData,
        }
    }
}

impl<T, L, S> Values<T::Raw> for On<T, L, S>
where
    T: Number,
    L: Law<T> + Send + Sync,
    S: Fn(&L, T) -> T + Send + Sync,
{
    #[inline]
    fn at_angle(&self, theta: Option<T::Raw>, pair: CosSin<T::Raw>) -> [T::Raw; AT_ANGLE.len()] {
        let law = &self.law;
        let (cos, sin) = (T::of_raw(pair.cos), T::of_raw(pair.sin));
        let pair = CosSin { cos, sin };
        let zero = T::default();
        let mut values = [zero; AT_ANGLE.len()];
        (values[3], values[4]) = (law.density(pair), law.lambert_weight(pair));
        (values[7], values[8]) = (law.unwarp(pair), law.unwarp_sf(pair));
        if self.planar {
            let mirrored = CosSin { cos, sin: -sin };
            (values[11], values[12]) = (law.unwarp(mirrored), law.unwarp_sf(mirrored));
        }
        if let Some(theta) = theta.map(T::of_raw) {
            (values[0], values[1]) = (law.pdf(theta), law.ln_pdf(theta));
            values[2] = (self.solid)(law, theta);
            (values[5], values[6]) = (law.cdf(theta), law.sf(theta));
            if self.planar {
                (values[9], values[10]) = (law.cdf(-theta), law.sf(-theta));
            }
        }
        values.map(T::raw)
    }

    #[inline]
    fn at_tail(&self, p: T::Raw) -> [T::Raw; AT_TAIL.len()] {
        let (law, p) = (&self.law, T::of_raw(p));
        let (lower, upper) = (law.warp(p), law.warp_sf(p));
        let (quantile, isf) = (law.quantile(p), law.isf(p));
        [lower.cos, lower.sin, upper.cos, upper.sin, quantile, isf].map(T::raw)
    }

    fn quantile(&self, p: T::Raw) -> T::Raw {
        self.law.quantile(T::of_raw(p)).raw()
    }

    fn isf(&self, p: T::Raw) -> T::Raw {
        self.law.isf(T::of_raw(p)).raw()
    }

    fn angles(&self, theta: Option<&[T::Raw]>, pairs: &[CosSin<T::Raw>], out: &mut [Vec<T::Raw>]) {
        for (i, &pair) in pairs.iter().enumerate() {
            let theta = theta.map(|theta| theta[i]);
            for (slot, value) in out.iter_mut().zip(self.at_angle(theta, pair)) {
                slot[i] = value;
            }
        }
    }

    fn tails(&self, p: &[T::Raw], out: &mut [Vec<T::Raw>]) {
        for (i, &p) in p.iter().enumerate() {
            for (slot, value) in out.iter_mut().zip(self.at_tail(p)) {
                slot[i] = value;
            }
        }
    }
}
