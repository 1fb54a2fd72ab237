//! Slices, element by element: the bits of the scalar calls, in loops that become vectors.
//!
//! Every function of a [`Law`](crate::Law) that ends in `_slice` runs through here. A block of
//! arguments is laid out in arrays of known length; what is left over at the end is a block as
//! well, filled up, so that all elements go the same way. A feature of its own, `simd`, chooses
//! the widest vectors of the processor while the program runs ([`width`]); without it they are
//! those compiled for.

mod lanes;
#[cfg(feature = "simd")]
pub mod width;

use crate::{Fast, Real};
use core::fmt;
use lanes::BLOCK;
pub(crate) use lanes::{Lanes, PlanarDraws, SpatialDraws, Words};

/// The number types of batches: [`prim@f32`], [`prim@f64`] and [`Fast<f32>`](Fast).
///
/// [`Precise`](crate::Precise) is none of them: it decides anew for every number how exactly to
/// compute.
pub trait Batch: Real {}

impl Batch for f32 {}
impl Batch for f64 {}
impl Batch for Fast<f32> {}

/// Slices of unequal length; nothing was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LengthError {
    /// Elements of the first slice.
    pub expected: usize,
    /// Elements of the first slice that has another number of them.
    pub found: usize,
}

impl fmt::Display for LengthError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let LengthError { expected, found } = self;
        write!(
            f,
            "a slice has {found} elements; expected {expected}, as the first has"
        )
    }
}

impl core::error::Error for LengthError {}

/// Writes `f` of each element of `from` to the slices `to`.
#[inline]
pub(crate) fn map<T: Batch, L: Lanes, const N: usize>(
    from: L,
    to: [&mut [T]; N],
    f: impl Fn(L::Item) -> [T; N],
) -> Result<(), LengthError> {
    let expected = equal_lengths(from.len().into_iter().chain(to.iter().map(|to| to.len())))?;
    let blocks = Blocks {
        len: expected,
        from,
        to,
        f,
    };
    #[cfg(feature = "simd")]
    width::dispatch(blocks);
    #[cfg(not(feature = "simd"))]
    blocks.run();
    Ok(())
}

fn equal_lengths(mut lengths: impl Iterator<Item = usize>) -> Result<usize, LengthError> {
    let expected = lengths.next().unwrap_or_default();
    match lengths.find(|&n| n != expected) {
        Some(found) => Err(LengthError { expected, found }),
        None => Ok(expected),
    }
}

/// A batch of known length, ready to run at some width.
struct Blocks<'a, T, L, F, const N: usize> {
    len: usize,
    from: L,
    to: [&'a mut [T]; N],
    f: F,
}

/// Bytes of a cache's line.
const LINE: usize = 64;

/// Elements of a batch that a block more is little of.
const LONG: usize = 16 * BLOCK;

/// As lines of a cache lie.
#[repr(align(64))]
struct Aligned<A>(A);

impl<T: Batch, L: Lanes, F: Fn(L::Item) -> [T; N], const N: usize> Blocks<'_, T, L, F, N> {
    /// Elements of the block at `at`: of a long batch the first ends where a line of the cache
    /// begins, so that no store of the others lies across two.
    #[inline(always)]
    fn length(&self, at: usize) -> usize {
        let Some(to) = self.to.first().filter(|_| at == 0 && self.len >= LONG) else {
            return BLOCK;
        };
        match to.as_ptr().align_offset(LINE) {
            0 => BLOCK,
            head => head.min(BLOCK),
        }
    }

    #[inline(always)]
    fn run(mut self) {
        // Once for all blocks: zeros for each would take as long as some laws.
        let mut block = Aligned(L::zeros());
        let mut results = Aligned([[T::ZERO; BLOCK]; N]);
        let mut at = 0;
        while at < self.len {
            let len = self.length(at).min(self.len - at);
            self.from.fill(at, len, &mut block.0);
            for i in 0..BLOCK {
                let result = (self.f)(L::item(&block.0, i));
                for (to, value) in results.0.iter_mut().zip(result) {
                    to[i] = value;
                }
            }
            for (to, values) in self.to.iter_mut().zip(&results.0) {
                write(to, at, values);
            }
            at += len;
        }
    }
}

/// `values` from `at` on, as many as there is room for.
#[inline(always)]
fn write<T: Copy>(to: &mut [T], at: usize, values: &[T; BLOCK]) {
    let rest = to.get_mut(at..).unwrap_or_default();
    if let Some(whole) = rest.first_chunk_mut() {
        *whole = *values;
    } else {
        // Not a copy of their length: a compiler would make one call of both.
        for (i, &value) in values.iter().enumerate() {
            if let Some(to) = rest.get_mut(i) {
                *to = value;
            }
        }
    }
}
