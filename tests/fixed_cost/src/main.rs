//! Every fixed-point operation in one image, each a function that tools/fixed_cost.py runs and counts. It links
//! only if no panic is reachable, since the panic handler calls a symbol that exists nowhere, and `check` refuses it if
//! a float routine is linked. `--cfg planted` adds one sum in `f32`, which the check must catch.
#![no_std]
#![no_main]

mod operations;

use ::fixed::types::{I0F16, I0F32, I1F15, I1F31, U16F16};
use core::convert::Infallible;
use core::hint::black_box;
use coslobe::fixed::{self, CosPower, FixedLaw};
use coslobe::fixed16::{self, Fixed16Law};
use coslobe::rand_core::{Rng, TryRng};
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Fixed, Fixed16, Lambert, SphereShell};

unsafe extern "C" {
    fn a_panic_is_reachable() -> !;
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    unsafe { a_panic_is_reachable() }
}

/// Marsaglia's xorshift32.
pub struct Xorshift(u32);

impl TryRng for Xorshift {
    type Error = Infallible;
    #[inline(always)]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        Ok(self.0)
    }
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        Ok(u64::from(self.try_next_u32()?) << 32 | u64::from(self.try_next_u32()?))
    }
    fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), Infallible> {
        Ok(())
    }
}

/// O'Neill's PCG32 (XSH RR).
pub struct Pcg(u64);

impl TryRng for Pcg {
    type Error = Infallible;
    #[inline(always)]
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        let old = self.0;
        self.0 = old
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        let word = (((old >> 18) ^ old) >> 27) as u32;
        Ok(word.rotate_right((old >> 59) as u32))
    }
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        Ok(u64::from(self.try_next_u32()?) << 32 | u64::from(self.try_next_u32()?))
    }
    fn try_fill_bytes(&mut self, _: &mut [u8]) -> Result<(), Infallible> {
        Ok(())
    }
}

extern "C" fn empty() {}

extern "C" fn word<R: Rng>(rng: &mut R) -> u32 {
    rng.next_u32()
}

/// A law in either type.
pub trait Operations {
    type Component;
    type Probability;
    type Turn;
    type Density;
    type Direction;
    fn warp(&self, u: Self::Probability) -> CosSin<Self::Component>;
    fn warp_sf(&self, q: Self::Probability) -> CosSin<Self::Component>;
    fn quantile(&self, p: Self::Probability) -> Self::Turn;
    fn isf(&self, p: Self::Probability) -> Self::Turn;
    fn cdf(&self, theta: Self::Turn) -> Self::Probability;
    fn sf(&self, theta: Self::Turn) -> Self::Probability;
    fn pdf(&self, theta: Self::Turn) -> Self::Density;
    fn density(&self, at: CosSin<Self::Component>) -> Self::Density;
    fn unwarp(&self, at: CosSin<Self::Component>) -> Self::Probability;
    fn unwarp_sf(&self, at: CosSin<Self::Component>) -> Self::Probability;
    fn sample<R: Rng>(&self, rng: &mut R) -> Self::Direction;
}

extern "C" fn turn_cos_sin(_: u32, turn: i32, out: &mut CosSin<I1F31>) {
    *out = fixed::cos_sin(I0F32::from_bits(turn));
}

extern "C" fn turn_cos_sin16(_: u32, turn: i16, out: &mut CosSin<I1F15>) {
    *out = fixed16::cos_sin(I0F16::from_bits(turn));
}

extern "C" fn new_cos_power(out: &mut Fixed<CosPower>, k: u32) {
    *out = Fixed(CosPower::new(U16F16::from_bits(k)));
}

extern "C" fn warp<L: Operations>(law: &L, u: L::Probability, out: &mut CosSin<L::Component>) {
    *out = law.warp(u);
}

extern "C" fn warp_sf<L: Operations>(law: &L, q: L::Probability, out: &mut CosSin<L::Component>) {
    *out = law.warp_sf(q);
}

extern "C" fn quantile<L: Operations>(law: &L, p: L::Probability) -> L::Turn {
    law.quantile(p)
}

extern "C" fn isf<L: Operations>(law: &L, p: L::Probability) -> L::Turn {
    law.isf(p)
}

extern "C" fn cdf<L: Operations>(law: &L, theta: L::Turn) -> L::Probability {
    law.cdf(theta)
}

extern "C" fn sf<L: Operations>(law: &L, theta: L::Turn) -> L::Probability {
    law.sf(theta)
}

extern "C" fn pdf<L: Operations>(law: &L, theta: L::Turn, out: &mut L::Density) {
    *out = law.pdf(theta);
}

extern "C" fn density<L: Operations<Component: Copy>>(
    law: &L,
    at: &CosSin<L::Component>,
    out: &mut L::Density,
) {
    *out = law.density(*at);
}

extern "C" fn unwarp<L: Operations<Component: Copy>>(
    law: &L,
    at: &CosSin<L::Component>,
) -> L::Probability {
    law.unwarp(*at)
}

extern "C" fn unwarp_sf<L: Operations<Component: Copy>>(
    law: &L,
    at: &CosSin<L::Component>,
) -> L::Probability {
    law.unwarp_sf(*at)
}

extern "C" fn sample<L: Operations, R: Rng>(law: &L, rng: &mut R, out: &mut L::Direction) {
    *out = law.sample(rng);
}

/// Refers to every operation of a law, so that none is left out of the image.
fn keep<L: Operations<Component: Copy>>() {
    black_box([
        warp::<L> as *const (),
        warp_sf::<L> as *const (),
        quantile::<L> as *const (),
        isf::<L> as *const (),
        cdf::<L> as *const (),
        sf::<L> as *const (),
        pdf::<L> as *const (),
        density::<L> as *const (),
        unwarp::<L> as *const (),
        unwarp_sf::<L> as *const (),
        sample::<L, Xorshift> as *const (),
        sample::<L, Pcg> as *const (),
    ]);
}

fn keep_both<L>()
where
    L: FixedLaw + Fixed16Law,
{
    keep::<Fixed<L>>();
    keep::<Fixed16<L>>();
}

/// The image's entry.
#[unsafe(no_mangle)]
pub extern "C" fn _start(x: u32) -> u32 {
    keep_both::<Lambert>();
    keep_both::<SphereShell>();
    keep_both::<Ball>();
    keep::<Fixed<CosPower>>();
    keep_both::<Disk>();
    keep_both::<CircleShell>();
    keep_both::<CircleArc>();
    black_box([
        empty as *const (),
        turn_cos_sin as *const (),
        turn_cos_sin16 as *const (),
        new_cos_power as *const (),
        word::<Xorshift> as *const (),
        word::<Pcg> as *const (),
    ]);
    if cfg!(planted) {
        return (x as f32 + 0.1) as u32;
    }
    x
}
