//! Every fixed-point operation in one image, each a function that tools/fixed_cost.py runs and counts. It links
//! only if no panic is reachable, since the panic handler calls a symbol that exists nowhere, and `check` refuses it if
//! a float routine is linked. `--cfg planted` adds one sum in `f32`, which the check must catch.
#![no_std]
#![no_main]

use core::convert::Infallible;
use core::hint::black_box;
use coslobe::fixed::{CosPower, FixedLaw, cos_sin};
use coslobe::rand_core::{Rng, TryRng};
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Fixed, Lambert, SphereShell};
use fixed::types::{I0F32, I1F31, U0F32, U16F16};

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

extern "C" fn turn_cos_sin(_: u32, turn: i32, out: &mut CosSin<I1F31>) {
    *out = cos_sin(I0F32::from_bits(turn));
}

extern "C" fn new_cos_power(out: &mut Fixed<CosPower>, k: u32) {
    *out = Fixed(CosPower::new(U16F16::from_bits(k)));
}

extern "C" fn warp<L: FixedLaw>(law: &Fixed<L>, u: u32, out: &mut CosSin<I1F31>) {
    *out = law.warp(U0F32::from_bits(u));
}

extern "C" fn warp_sf<L: FixedLaw>(law: &Fixed<L>, q: u32, out: &mut CosSin<I1F31>) {
    *out = law.warp_sf(U0F32::from_bits(q));
}

extern "C" fn quantile<L: FixedLaw>(law: &Fixed<L>, p: u32) -> i32 {
    law.quantile(U0F32::from_bits(p)).to_bits()
}

extern "C" fn isf<L: FixedLaw>(law: &Fixed<L>, p: u32) -> i32 {
    law.isf(U0F32::from_bits(p)).to_bits()
}

extern "C" fn cdf<L: FixedLaw>(law: &Fixed<L>, turn: i32) -> u32 {
    law.cdf(I0F32::from_bits(turn)).to_bits()
}

extern "C" fn sf<L: FixedLaw>(law: &Fixed<L>, turn: i32) -> u32 {
    law.sf(I0F32::from_bits(turn)).to_bits()
}

extern "C" fn pdf<L: FixedLaw>(law: &Fixed<L>, turn: i32, out: &mut L::Density) {
    *out = law.pdf(I0F32::from_bits(turn));
}

extern "C" fn density<L: FixedLaw>(law: &Fixed<L>, at: &CosSin<I1F31>, out: &mut L::Density) {
    *out = law.density(*at);
}

extern "C" fn unwarp<L: FixedLaw>(law: &Fixed<L>, at: &CosSin<I1F31>) -> u32 {
    law.unwarp(*at).to_bits()
}

extern "C" fn unwarp_sf<L: FixedLaw>(law: &Fixed<L>, at: &CosSin<I1F31>) -> u32 {
    law.unwarp_sf(*at).to_bits()
}

extern "C" fn sample<L: FixedLaw, R: Rng>(law: &Fixed<L>, rng: &mut R, out: &mut L::Direction) {
    *out = law.sample(rng);
}

/// Refers to every operation of a law, so that none is left out of the image.
fn keep<L: FixedLaw>() {
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

/// The image's entry.
#[unsafe(no_mangle)]
pub extern "C" fn _start(x: u32) -> u32 {
    keep::<Lambert>();
    keep::<SphereShell>();
    keep::<Ball>();
    keep::<CosPower>();
    keep::<Disk>();
    keep::<CircleShell>();
    keep::<CircleArc>();
    black_box([
        empty as *const (),
        turn_cos_sin as *const (),
        new_cos_power as *const (),
        word::<Xorshift> as *const (),
        word::<Pcg> as *const (),
    ]);
    if cfg!(planted) {
        return (x as f32 + 0.1) as u32;
    }
    x
}
