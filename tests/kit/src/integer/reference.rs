//! The operations of the 32-bit type beside what they should be.

use super::truth::Truth;
pub use super::truth::power_pair;
use crate::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law};
use coslobe::integers::FixedRadius;
use coslobe::{CosSin, Fixed};
use fixed::types::{I0F32, I1F31, I32F0, U0F32, U16F16};
use std::ops::Deref;

pub const Q31: f64 = 2147483648.0;
pub const Q32: f64 = 4294967296.0;

/// A law and its fixed-point operations on bare words.
#[derive(Clone, Copy)]
pub struct Subject {
    pub truth: Truth,
    pub warp: fn(u32) -> CosSin<I1F31>,
    pub warp_sf: fn(u32) -> CosSin<I1F31>,
    pub unwarp: fn(CosSin<I1F31>) -> U0F32,
    pub unwarp_sf: fn(CosSin<I1F31>) -> U0F32,
    pub density: fn(CosSin<I1F31>) -> U0F32,
    pub lambert_weight: fn(CosSin<I1F31>) -> U16F16,
    /// Of a radius in units.
    pub distance: fn(i32, CosSin<I1F31>, u32) -> i32,
    pub pdf: fn(i32) -> U0F32,
    pub cdf: fn(i32) -> U0F32,
    pub sf: fn(i32) -> U0F32,
    pub quantile: fn(u32) -> I0F32,
    pub isf: fn(u32) -> I0F32,
}

impl Deref for Subject {
    type Target = Truth;
    fn deref(&self) -> &Truth {
        &self.truth
    }
}

/// Every law without a parameter, in the order of [`Id::FIXED`](crate::Id::FIXED).
pub fn subjects() -> Vec<Subject> {
    let mut all = Subjects(Vec::new());
    every_integer_law(&mut all);
    all.0
}

struct Subjects(Vec<Subject>);

impl IntegerVisitor for Subjects {
    fn law<L: IntegerLaw>(&mut self, _: L) {
        self.0.push(Subject {
            truth: Truth::of(L::ID),
            warp: |u| Fixed(L::default()).warp(U0F32::from_bits(u)),
            warp_sf: |u| Fixed(L::default()).warp_sf(U0F32::from_bits(u)),
            unwarp: |at| Fixed(L::default()).unwarp(at),
            unwarp_sf: |at| Fixed(L::default()).unwarp_sf(at),
            density: |at| Fixed(L::default()).density(at),
            lambert_weight: |at| Fixed(L::default()).lambert_weight(at),
            distance: |rho, at, v| {
                let rho = FixedRadius::new(I32F0::from_bits(rho)).expect("a radius");
                let v = U0F32::from_bits(v);
                Fixed(L::default()).distance(rho, at, v).to_bits()
            },
            pdf: |t| Fixed(L::default()).pdf(I0F32::from_bits(t)),
            cdf: |t| Fixed(L::default()).cdf(I0F32::from_bits(t)),
            sf: |t| Fixed(L::default()).sf(I0F32::from_bits(t)),
            quantile: |u| Fixed(L::default()).quantile(U0F32::from_bits(u)),
            isf: |u| Fixed(L::default()).isf(U0F32::from_bits(u)),
        });
    }
}
