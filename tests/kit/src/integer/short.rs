//! The operations of the 16-bit type beside what they should be.

use crate::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law};
use crate::integer::truth::Truth;
use coslobe::integers::{Fixed16Law, FixedRadius};
use coslobe::{CosSin, Fixed16};
use fixed::types::{I0F16, I1F15, I16F0, U0F16, U16F16};
use std::ops::Deref;

/// A component of 1.
pub const Q15: f64 = 32768.0;

pub type Pair = CosSin<I1F15>;

/// A law and its operations on bare words.
#[derive(Clone, Copy)]
pub struct Subject {
    pub truth: Truth,
    pub warp: fn(u16) -> Pair,
    pub warp_sf: fn(u16) -> Pair,
    pub unwarp: fn(Pair) -> u16,
    pub unwarp_sf: fn(Pair) -> u16,
    pub density: fn(Pair) -> u16,
    pub lambert_weight: fn(Pair) -> U16F16,
    /// Of a radius in units.
    pub distance: fn(i16, Pair, u16) -> i16,
    pub pdf: fn(i16) -> u16,
    pub cdf: fn(i16) -> u16,
    pub sf: fn(i16) -> u16,
    pub quantile: fn(u16) -> i16,
    pub isf: fn(u16) -> i16,
}

impl Deref for Subject {
    type Target = Truth;
    fn deref(&self) -> &Truth {
        &self.truth
    }
}

fn law<L: Fixed16Law + Default>() -> Fixed16<L> {
    Fixed16(L::default())
}

/// Every law, in the order of [`crate::Id::FIXED`].
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
            warp: |u| law::<L>().warp(U0F16::from_bits(u)),
            warp_sf: |u| law::<L>().warp_sf(U0F16::from_bits(u)),
            unwarp: |at| law::<L>().unwarp(at).to_bits(),
            unwarp_sf: |at| law::<L>().unwarp_sf(at).to_bits(),
            density: |at| law::<L>().density(at).to_bits(),
            lambert_weight: |at| law::<L>().lambert_weight(at),
            distance: |rho, at, v| {
                let rho = FixedRadius::new(I16F0::from_bits(rho)).expect("a radius");
                law::<L>().distance(rho, at, U0F16::from_bits(v)).to_bits()
            },
            pdf: |t| law::<L>().pdf(I0F16::from_bits(t)).to_bits(),
            cdf: |t| law::<L>().cdf(I0F16::from_bits(t)).to_bits(),
            sf: |t| law::<L>().sf(I0F16::from_bits(t)).to_bits(),
            quantile: |u| law::<L>().quantile(U0F16::from_bits(u)).to_bits(),
            isf: |u| law::<L>().isf(U0F16::from_bits(u)).to_bits(),
        });
    }
}
