//! A generator made of a function: for hardware, and for generators of another `rand_core`.

use core::convert::Infallible;
use core::error::Error;
use rand_core::{TryRng, utils};

/// A generator whose words `f` gives.
///
/// Most hardware abstraction layers implement `rand_core` 0.6 or 0.9, whose traits are not those
/// of 0.10 that the samplers ask for. One line leads from there to here:
///
/// ```
/// # mod rand_core_06 { pub trait RngCore { fn next_u32(&mut self) -> u32; } }
/// # struct HardwareRng(u32);
/// # impl rand_core_06::RngCore for HardwareRng {
/// #     fn next_u32(&mut self) -> u32 {
/// #         self.0 = self.0.wrapping_mul(747796405).wrapping_add(1);
/// #         self.0
/// #     }
/// # }
/// # let mut hardware = HardwareRng(1);
/// use coslobe::{Lambert, from_fn};
/// use rand_core_06::RngCore; // `rand_core` 0.6 or 0.9, as the HAL has it
/// let mut rng = from_fn(|| hardware.next_u32());
/// let [x, y, z]: [f32; 3] = Lambert.sample(&mut rng);
/// assert!(y > 0.0);
/// # let _ = (x, z);
/// ```
///
/// A `u64` is two words, the lower half first.
#[inline]
pub fn from_fn<F: FnMut() -> u32>(f: F) -> FromFn<F> {
    FromFn(f)
}

/// A generator that can fail, whose words `f` gives: for `try_sample`.
///
/// ```
/// use coslobe::{Ball, Spatial, try_from_fn};
/// use std::io::{Error, ErrorKind};
/// let mut left = 2;
/// let mut rng = try_from_fn(|| {
///     left -= 1;
///     if left < 0 { Err(Error::from(ErrorKind::TimedOut)) } else { Ok(0x1234_5678) }
/// });
/// let ray: Result<[f32; 3], _> = Ball.try_sample(&mut rng); // takes three words
/// assert_eq!(ray.unwrap_err().kind(), ErrorKind::TimedOut);
/// ```
///
/// A `u64` is two words, the lower half first.
#[inline]
pub fn try_from_fn<E: Error, F: FnMut() -> Result<u32, E>>(f: F) -> TryFromFn<F> {
    TryFromFn(f)
}

/// See [`from_fn`].
#[derive(Clone, Copy, Debug)]
pub struct FromFn<F>(F);

/// See [`try_from_fn`].
#[derive(Clone, Copy, Debug)]
pub struct TryFromFn<F>(F);

impl<F: FnMut() -> u32> TryRng for FromFn<F> {
    type Error = Infallible;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        Ok((self.0)())
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        utils::next_u64_via_u32(self)
    }

    #[inline]
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        utils::fill_bytes_via_next_word(bytes, || self.try_next_u32())
    }
}

impl<E: Error, F: FnMut() -> Result<u32, E>> TryRng for TryFromFn<F> {
    type Error = E;

    #[inline]
    fn try_next_u32(&mut self) -> Result<u32, E> {
        (self.0)()
    }

    #[inline]
    fn try_next_u64(&mut self) -> Result<u64, E> {
        utils::next_u64_via_u32(self)
    }

    #[inline]
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), E> {
        utils::fill_bytes_via_next_word(bytes, || self.try_next_u32())
    }
}
