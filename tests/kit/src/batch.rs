//! The number types that batches have, and the bits that their samplers take from words.

use crate::Number;
use coslobe::uniform::{TailBits, TurnBits};
use coslobe::{Batch, Fast};

/// A number type of batches.
pub trait BatchNumber: Batch + Number {
    /// The bits of one probability.
    fn tail_bits(next: &mut impl FnMut() -> u64) -> TailBits<Self>;
    /// The bits of one azimuth.
    fn turn_bits(next: &mut impl FnMut() -> u64) -> TurnBits<Self>;
}

impl BatchNumber for f32 {
    fn tail_bits(next: &mut impl FnMut() -> u64) -> u64 {
        next()
    }
    fn turn_bits(next: &mut impl FnMut() -> u64) -> u32 {
        (next() >> 32) as u32
    }
}

impl BatchNumber for f64 {
    fn tail_bits(next: &mut impl FnMut() -> u64) -> u128 {
        u128::from(next()) << 64 | u128::from(next())
    }
    fn turn_bits(next: &mut impl FnMut() -> u64) -> u64 {
        next()
    }
}

impl BatchNumber for Fast<f32> {
    fn tail_bits(next: &mut impl FnMut() -> u64) -> u64 {
        next()
    }
    fn turn_bits(next: &mut impl FnMut() -> u64) -> u32 {
        (next() >> 32) as u32
    }
}

/// Is shown number types of batches.
pub trait BatchVisitor {
    /// One of them.
    fn number<T: BatchNumber>(&mut self);
}

/// Shows every number type that batches have.
pub fn every_batch_number(visitor: &mut impl BatchVisitor) {
    visitor.number::<f32>();
    visitor.number::<f64>();
    visitor.number::<Fast<f32>>();
}
