//! How wide the vectors of batches are. It changes no value.

use super::{Batch, Blocks, Lanes};
use core::sync::atomic::{AtomicU8, Ordering};
use pulp::NullaryFnOnce;

/// The vectors that a batch is computed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum Width {
    /// What the program is compiled for: SSE2 on x86-64, NEON on aarch64, unless more is asked for.
    Compiled,
    /// AVX2: 256 bits.
    Avx2,
    /// AVX-512: 512 bits.
    Avx512,
}

/// As if by [`limit`], from the start.
static LIMIT: AtomicU8 = AtomicU8::new(Width::Avx512 as u8);

/// The widest that this processor has.
#[must_use]
pub fn widest() -> Width {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    match pulp::Arch::new() {
        pulp::Arch::V4(_) => return Width::Avx512,
        pulp::Arch::V3(_) => return Width::Avx2,
        _ => {}
    }
    Width::Compiled
}

/// From now on, in all threads, batches use no wider vectors than these; those that the processor
/// lacks are never used. For comparisons, and for processors that widest vectors slow down.
pub fn limit(width: Width) {
    LIMIT.store(width as u8, Ordering::Relaxed);
}

/// The widest that a batch may use.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
fn limited() -> Width {
    match LIMIT.load(Ordering::Relaxed) {
        0 => Width::Compiled,
        1 => Width::Avx2,
        _ => Width::Avx512,
    }
}

impl<T: Batch, L: Lanes, F: Fn(L::Item) -> [T; N], const N: usize> NullaryFnOnce
    for Blocks<'_, T, L, F, N>
{
    type Output = ();

    #[inline(always)]
    fn call(self) {
        self.run();
    }
}

/// Runs the batch in the widest vectors there are and may be.
#[inline]
pub(super) fn dispatch(batch: impl NullaryFnOnce) {
    #[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
    match (pulp::Arch::new(), limited()) {
        (pulp::Arch::V4(simd), Width::Avx512) => {
            simd.vectorize(batch);
            return;
        }
        (pulp::Arch::V4(simd), Width::Avx2) => {
            (*simd).vectorize(batch);
            return;
        }
        (pulp::Arch::V3(simd), Width::Avx512 | Width::Avx2) => {
            simd.vectorize(batch);
            return;
        }
        _ => {}
    }
    batch.call();
}

#[cfg(all(test, any(target_arch = "x86", target_arch = "x86_64")))]
mod tests {
    use super::*;

    #[test]
    fn batches_read_the_limit() {
        for width in [Width::Compiled, Width::Avx2, Width::Avx512] {
            limit(width);
            assert_eq!(limited(), width);
        }
    }
}
