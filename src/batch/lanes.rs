//! What a batch reads, a block at a time: arrays of known length, over which loops become vectors.

use crate::arithmetic::tier::Tier;
use core::marker::PhantomData;
use rand_core::Rng;

/// Elements of a block.
pub(super) const BLOCK: usize = 64;

/// Where a batch's arguments come from.
pub(crate) trait Lanes {
    /// The arguments of one element.
    type Item;
    /// Those of a block, each kind in an array of its own.
    type Block;

    /// The lengths of its slices.
    fn len(&self) -> impl IntoIterator<Item = usize>;
    /// The next `len` ≤ [`BLOCK`] from `at` on, filled up with zeros.
    fn block(&mut self, at: usize, len: usize) -> Self::Block;
    fn item(block: &Self::Block, i: usize) -> Self::Item;
}

impl<A: Copy + Default> Lanes for &[A] {
    type Item = A;
    type Block = [A; BLOCK];

    #[inline(always)]
    fn len(&self) -> impl IntoIterator<Item = usize> {
        [<[A]>::len(self)]
    }

    #[inline(always)]
    fn block(&mut self, at: usize, len: usize) -> [A; BLOCK] {
        let rest = self.get(at..).unwrap_or_default();
        if let Some(whole) = rest.first_chunk() {
            return *whole;
        }
        let mut block = [A::default(); BLOCK];
        for (to, from) in block.iter_mut().zip(rest).take(len) {
            *to = *from;
        }
        block
    }

    #[inline(always)]
    fn item(block: &[A; BLOCK], i: usize) -> A {
        block[i]
    }
}

impl<X: Lanes, Y: Lanes> Lanes for (X, Y) {
    type Item = (X::Item, Y::Item);
    type Block = (X::Block, Y::Block);

    #[inline(always)]
    fn len(&self) -> impl IntoIterator<Item = usize> {
        self.0.len().into_iter().chain(self.1.len())
    }

    #[inline(always)]
    fn block(&mut self, at: usize, len: usize) -> Self::Block {
        (self.0.block(at, len), self.1.block(at, len))
    }

    #[inline(always)]
    fn item(block: &Self::Block, i: usize) -> Self::Item {
        (X::item(&block.0, i), Y::item(&block.1, i))
    }
}

/// The words that as many calls of `sample` draw, in that order.
pub(crate) struct Draws<'a, T, R: ?Sized> {
    rng: &'a mut R,
    number: PhantomData<T>,
}

impl<'a, T: Tier, R: Rng + ?Sized> Draws<'a, T, R> {
    pub(crate) fn new(rng: &'a mut R) -> Self {
        Draws {
            rng,
            number: PhantomData,
        }
    }
}

/// Words of a law in space: of θ, and of the azimuth.
impl<T: Tier, R: Rng + ?Sized> Lanes for Draws<'_, T, R> {
    type Item = (T::TailBits, T::TurnBits);
    type Block = ([T::TailBits; BLOCK], [T::TurnBits; BLOCK]);

    #[inline(always)]
    fn len(&self) -> impl IntoIterator<Item = usize> {
        []
    }

    #[inline(always)]
    fn block(&mut self, _: usize, len: usize) -> Self::Block {
        let mut tails = [T::TailBits::default(); BLOCK];
        let mut turns = [T::TurnBits::default(); BLOCK];
        for (tail, turn) in tails.iter_mut().zip(&mut turns).take(len) {
            *tail = T::draw_tail_bits(self.rng);
            *turn = T::draw_turn_bits(self.rng);
        }
        (tails, turns)
    }

    #[inline(always)]
    fn item(block: &Self::Block, i: usize) -> Self::Item {
        (block.0[i], block.1[i])
    }
}
