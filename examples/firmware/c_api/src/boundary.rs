//! Where C's pointers are followed: nowhere else.

use core::convert::Infallible;
use core::ffi::c_void;
use coslobe::rand_core::TryRng;

/// What became of a call that writes through a pointer.
#[repr(i32)]
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum CoslobeStatus {
    /// The result was written.
    Ok = 0,
    /// The generator, its function or the result is a null pointer: nothing was drawn or written.
    NullPointer = 1,
    /// The exponent is NaN, negative or infinite: nothing was drawn or written.
    Exponent = 2,
}

/// A generator of random words.
#[repr(C)]
pub struct CoslobeRng {
    /// Returns 32 uniform bits; called with `context`. Where 64 bits are taken, the low word comes first.
    pub next_u32: Option<unsafe extern "C" fn(context: *mut c_void) -> u32>,
    /// Handed to `next_u32`; may be null.
    pub context: *mut c_void,
}

/// A `CoslobeRng` that was found to have a function.
pub struct Words {
    next_u32: unsafe extern "C" fn(*mut c_void) -> u32,
    context: *mut c_void,
}

impl TryRng for Words {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        // SAFETY: the caller of `draw` promises that the function may be called with its context.
        Ok(unsafe { (self.next_u32)(self.context) })
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        let low = u64::from(self.try_next_u32()?);
        Ok(low | u64::from(self.try_next_u32()?) << 32)
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        for chunk in bytes.chunks_mut(4) {
            let word = self.try_next_u32()?.to_le_bytes();
            chunk.iter_mut().zip(word).for_each(|(to, from)| *to = from);
        }
        Ok(())
    }
}

/// Writes what `sample` draws to `direction`.
///
/// # Safety
/// Each pointer is null or valid: `rng` for a read, its function for calls with its context, `direction`
/// for a write.
pub unsafe fn draw<D>(
    rng: *const CoslobeRng,
    direction: *mut D,
    sample: impl FnOnce(&mut Words) -> D,
) -> CoslobeStatus {
    if rng.is_null() || direction.is_null() {
        return CoslobeStatus::NullPointer;
    }
    // SAFETY: not null, so valid for a read, as the caller promises.
    let (next_u32, context) = unsafe { ((*rng).next_u32, (*rng).context) };
    let Some(next_u32) = next_u32 else {
        return CoslobeStatus::NullPointer;
    };
    let mut words = Words { next_u32, context };
    // SAFETY: not null, so valid for a write, as the caller promises.
    unsafe { direction.write(sample(&mut words)) };
    CoslobeStatus::Ok
}
