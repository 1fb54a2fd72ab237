//! Counting what a render does, by effect; the meter `()` counts nothing and costs nothing.

use crate::{Effect, Number};
use core::marker::PhantomData;

/// Hears of every ray and every random word.
pub trait Meter {
    /// Words of a stream's first block that are used.
    const FIRST: usize = 4;
    /// A random word was drawn for `effect`.
    #[inline(always)]
    fn word(&mut self, _effect: Effect) {}
    /// A ray was traced for `effect`.
    #[inline(always)]
    fn ray(&mut self, _effect: Effect) {}
    /// The code of `effect` was entered.
    #[inline(always)]
    fn run(&mut self, _effect: Effect) {}
}

impl Meter for () {}

/// Counts nothing; draws the same numbers in every number type, to their precision: a stream's
/// second number begins its second block, whatever count of words the first, a tail, took in the
/// type `T`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Aligned<T>(PhantomData<T>);

impl<T: Number> Meter for Aligned<T> {
    const FIRST: usize = T::TAIL_WORDS;
}

/// Counts of one effect each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counters {
    /// 32-bit random words.
    pub words: [u64; Effect::COUNT],
    /// Rays.
    pub rays: [u64; Effect::COUNT],
    /// Times the effect's code was entered.
    pub runs: [u64; Effect::COUNT],
}

impl Meter for Counters {
    fn word(&mut self, effect: Effect) {
        self.words[effect as usize] += 1;
    }
    fn ray(&mut self, effect: Effect) {
        self.rays[effect as usize] += 1;
    }
    fn run(&mut self, effect: Effect) {
        self.runs[effect as usize] += 1;
    }
}
