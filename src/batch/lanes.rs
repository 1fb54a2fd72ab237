//! What a batch reads, a block at a time: arrays of known length, over which loops become vectors.

use crate::number::tier::Bits;

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

/// Random words that are given.
pub(crate) struct Words<'a, B>(pub(crate) &'a [B]);

impl<B: Bits> Lanes for Words<'_, B> {
    type Item = B;
    type Block = [[B::Half; BLOCK]; 2];

    #[inline(always)]
    fn len(&self) -> impl IntoIterator<Item = usize> {
        [self.0.len()]
    }

    #[inline(always)]
    fn block(&mut self, at: usize, len: usize) -> Self::Block {
        halves(&self.0.block(at, len))
    }

    #[inline(always)]
    fn item([upper, lower]: &Self::Block, i: usize) -> B {
        B::join(upper[i], lower[i])
    }
}

#[inline(always)]
fn halves<B: Bits>(words: &[B; BLOCK]) -> [[B::Half; BLOCK]; 2] {
    let [mut upper, mut lower] = [[B::Half::default(); BLOCK]; 2];
    for i in 0..BLOCK {
        (upper[i], lower[i]) = words[i].split();
    }
    [upper, lower]
}

/// The words that as many calls of `sample` of a law in the plane draw, in that order.
pub(crate) struct PlanarDraws<D>(pub(crate) D);

impl<B: Bits, D: FnMut() -> B> Lanes for PlanarDraws<D> {
    type Item = B;
    type Block = [[B::Half; BLOCK]; 2];

    #[inline(always)]
    fn len(&self) -> impl IntoIterator<Item = usize> {
        []
    }

    #[inline(always)]
    fn block(&mut self, _: usize, len: usize) -> Self::Block {
        let mut words = [B::default(); BLOCK];
        for word in words.iter_mut().take(len) {
            *word = self.0();
        }
        halves(&words)
    }

    #[inline(always)]
    fn item(block: &Self::Block, i: usize) -> B {
        Words::item(block, i)
    }
}

/// Those of a law in space: of θ, and of the azimuth.
pub(crate) struct SpatialDraws<D>(pub(crate) D);

impl<B: Bits, A: Copy + Default, D: FnMut() -> (B, A)> Lanes for SpatialDraws<D> {
    type Item = (B, A);
    type Block = ([[B::Half; BLOCK]; 2], [A; BLOCK]);

    #[inline(always)]
    fn len(&self) -> impl IntoIterator<Item = usize> {
        []
    }

    #[inline(always)]
    fn block(&mut self, _: usize, len: usize) -> Self::Block {
        let mut theta = [B::default(); BLOCK];
        let mut phi = [A::default(); BLOCK];
        for (theta, phi) in theta.iter_mut().zip(&mut phi).take(len) {
            (*theta, *phi) = self.0();
        }
        (halves(&theta), phi)
    }

    #[inline(always)]
    fn item((theta, phi): &Self::Block, i: usize) -> Self::Item {
        (Words::item(theta, i), phi[i])
    }
}
