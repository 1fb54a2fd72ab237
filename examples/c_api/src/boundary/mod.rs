//! Where C's pointers are followed, and nowhere else.
//!
//! What each function here asks of its pointers is what the header says: each is null, which a
//! status answers, or valid for what its name says, for the length of the call.

mod fault;

pub(crate) use fault::*;

use core::convert::Infallible;
use core::ffi::{c_int, c_void};
use core::marker::PhantomData;
use coslobe::rand_core::{Rng, TryRng};

/// The header's `COSLOBE_…`; above 0 is what the generator returned.
pub(crate) const OK: c_int = 0;
pub(crate) const NULL_POINTER: c_int = -1;
pub(crate) const EXPONENT: c_int = -2;
pub(crate) const RADIUS: c_int = -3;
pub(crate) const FAULT: c_int = -4;

/// `coslobe_cos_sin_…` of the header.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Pair<T> {
    pub(crate) cos: T,
    pub(crate) sin: T,
}

/// `coslobe_rng` of the header.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Generator {
    next_u32: Option<unsafe extern "C" fn(context: *mut c_void, word: *mut u32) -> c_int>,
    context: *mut c_void,
}

/// C's generator for the laws. After a failure it is not asked again and gives zeros, which no
/// one sees: what was made of them is not written.
pub(crate) struct Words {
    generator: Generator,
    failure: c_int,
}

impl TryRng for Words {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        let mut word = 0;
        if self.failure == OK
            && let Some(next) = self.generator.next_u32
        {
            // SAFETY: the header asks that the function may be called with its context.
            self.failure = unsafe { next(self.generator.context, &mut word) };
        }
        Ok(if self.failure == OK { word } else { 0 })
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        let low = u64::from(self.next_u32());
        Ok(low | u64::from(self.next_u32()) << 32)
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        for chunk in bytes.chunks_mut(4) {
            let word = self.next_u32().to_le_bytes();
            chunk.iter_mut().zip(word).for_each(|(to, from)| *to = from);
        }
        Ok(())
    }
}

/// # Safety
/// As in the file's head.
unsafe fn words(rng: *const Generator) -> Option<Words> {
    // SAFETY: null or valid for a read.
    let generator = *unsafe { rng.as_ref() }?;
    generator.next_u32?;
    Some(Words {
        generator,
        failure: OK,
    })
}

/// Writes what `sample` draws to `direction`; nothing if the generator fails.
///
/// # Safety
/// As in the file's head.
pub(crate) unsafe fn draw<D>(
    rng: *const Generator,
    direction: *mut D,
    sample: impl Fn(&mut Words) -> D,
) -> c_int {
    // SAFETY: one direction is written.
    unsafe { fill(rng, direction, 1, core::ptr::null_mut(), sample) }
}

/// As [`draw`], around a normal.
///
/// # Safety
/// As in the file's head.
pub(crate) unsafe fn around<N: Copy, D>(
    normal: *const N,
    rng: *const Generator,
    direction: *mut D,
    sample: impl Fn(N, &mut Words) -> D,
) -> c_int {
    // SAFETY: null or valid for a read.
    let Some(&normal) = (unsafe { normal.as_ref() }) else {
        return NULL_POINTER;
    };
    // SAFETY: the caller's promise.
    unsafe { draw(rng, direction, |words| sample(normal, words)) }
}

/// Writes `n` directions, and to `filled`, unless that is null, how many were written.
///
/// # Safety
/// As in the file's head.
pub(crate) unsafe fn fill<D>(
    rng: *const Generator,
    directions: *mut D,
    n: usize,
    filled: *mut usize,
    sample: impl Fn(&mut Words) -> D,
) -> c_int {
    // SAFETY: the caller's promise.
    let words = unsafe { words(rng) };
    let (mut i, mut status) = (0, NULL_POINTER);
    if let (Some(mut words), false) = (words, directions.is_null()) {
        while i < n {
            let direction = sample(&mut words);
            if words.failure != OK {
                break;
            }
            // SAFETY: i < n, and n directions may be written.
            unsafe { directions.add(i).write(direction) };
            i += 1;
        }
        status = words.failure;
    }
    // SAFETY: null or valid for a write.
    if let Some(filled) = unsafe { filled.as_mut() } {
        *filled = i;
    }
    status
}

/// Writes `value`.
///
/// # Safety
/// As in the file's head.
pub(crate) unsafe fn put<D>(to: *mut D, value: D) -> c_int {
    if to.is_null() {
        return NULL_POINTER;
    }
    // SAFETY: not null, so valid for a write.
    unsafe { to.write(value) };
    OK
}

/// A law with constants, in words that C can hold.
#[repr(C)]
pub struct Handle<L, const WORDS: usize> {
    state: [u32; WORDS],
    law: PhantomData<L>,
}

impl<L, const WORDS: usize> Handle<L, WORDS> {
    const FITS: () = assert!(size_of::<L>() <= 4 * WORDS);
}

/// Fills the handle in, or leaves it as it is where there is no law.
///
/// # Safety
/// As in the file's head.
pub(crate) unsafe fn init<L, const WORDS: usize>(
    handle: *mut Handle<L, WORDS>,
    law: Option<L>,
) -> c_int {
    const { Handle::<L, WORDS>::FITS };
    match law {
        Some(_) if handle.is_null() => NULL_POINTER,
        Some(law) => {
            // SAFETY: valid for a write, and no smaller than the law.
            unsafe { handle.cast::<L>().write_unaligned(law) };
            OK
        }
        None => EXPONENT,
    }
}

/// What `f` makes of the law, or `missing` where the handle is null.
///
/// # Safety
/// As in the file's head. Every pattern of bits is a law, if not one that means anything.
pub(crate) unsafe fn with<L: Copy, T, const WORDS: usize>(
    handle: *const Handle<L, WORDS>,
    missing: T,
    f: impl FnOnce(L) -> T,
) -> T {
    if handle.is_null() {
        return missing;
    }
    // SAFETY: not null, so valid for a read of no fewer words than the law has.
    f(unsafe { handle.cast::<L>().read_unaligned() })
}
