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
    /// Room for a block.
    fn zeros() -> Self::Block;
    /// Fills the first `len` ≤ [`BLOCK`] places of a block with the elements from `at` on, `len` of
    /// them or as many as the slices still have. What the others hold does not matter.
    fn fill(&mut self, at: usize, len: usize, block: &mut Self::Block);
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
    fn zeros() -> [A; BLOCK] {
        [A::default(); BLOCK]
    }

    #[inline(always)]
    fn fill(&mut self, at: usize, _: usize, block: &mut [A; BLOCK]) {
        let rest = self.get(at..).unwrap_or_default();
        if let Some(whole) = rest.first_chunk() {
            *block = *whole;
        } else {
            // Not a copy of what there is: a compiler would make one call of both.
            for (i, to) in block.iter_mut().enumerate() {
                *to = rest.get(i).copied().unwrap_or_default();
            }
        }
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
    fn zeros() -> Self::Block {
        (X::zeros(), Y::zeros())
    }

    #[inline(always)]
    fn fill(&mut self, at: usize, len: usize, (x, y): &mut Self::Block) {
        self.0.fill(at, len, x);
        self.1.fill(at, len, y);
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
    fn zeros() -> Self::Block {
        [[B::Half::default(); BLOCK]; 2]
    }

    #[inline(always)]
    fn fill(&mut self, at: usize, _: usize, [upper, lower]: &mut Self::Block) {
        let rest = self.0.get(at..).unwrap_or_default();
        for ((upper, lower), word) in upper.iter_mut().zip(lower).zip(rest) {
            (*upper, *lower) = word.split();
        }
    }

    #[inline(always)]
    fn item([upper, lower]: &Self::Block, i: usize) -> B {
        B::join(upper[i], lower[i])
    }
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
    fn zeros() -> Self::Block {
        Words::<B>::zeros()
    }

    #[inline(always)]
    fn fill(&mut self, _: usize, len: usize, [upper, lower]: &mut Self::Block) {
        for (upper, lower) in upper.iter_mut().zip(lower).take(len) {
            (*upper, *lower) = self.0().split();
        }
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
    fn zeros() -> Self::Block {
        (Words::<B>::zeros(), <&[A]>::zeros())
    }

    #[inline(always)]
    fn fill(&mut self, _: usize, len: usize, ([upper, lower], phi): &mut Self::Block) {
        for ((upper, lower), phi) in upper.iter_mut().zip(lower).zip(phi).take(len) {
            let (theta, turn) = self.0();
            (*upper, *lower) = theta.split();
            *phi = turn;
        }
    }

    #[inline(always)]
    fn item((theta, phi): &Self::Block, i: usize) -> Self::Item {
        (Words::item(theta, i), phi[i])
    }
}
