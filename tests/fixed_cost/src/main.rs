//! Each operation as a function of words, for tools/fixed_cost.py. It links only if no panic is reachable:
//! the panic handler calls a symbol that exists nowhere.
#![no_std]
#![no_main]

use core::convert::Infallible;
use coslobe::fixed::{FixedLaw, cos_sin};
use coslobe::rand_core::TryRng;
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Fixed, Lambert, SphereShell};
use fixed::types::{I0F32, I1F31, U0F32};

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
        self.0 = old.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
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

#[unsafe(no_mangle)]
pub extern "C" fn empty(_: u32, _: u32) {}

#[unsafe(no_mangle)]
pub extern "C" fn xorshift_word(rng: &mut Xorshift) -> u32 {
    let Ok(word) = rng.try_next_u32();
    word
}

#[unsafe(no_mangle)]
pub extern "C" fn pcg_word(rng: &mut Pcg) -> u32 {
    let Ok(word) = rng.try_next_u32();
    word
}

#[unsafe(no_mangle)]
pub extern "C" fn turn_cos_sin(turn: u32, out: &mut CosSin<I1F31>) {
    *out = cos_sin(I0F32::from_bits(turn as i32));
}

fn warp<L: FixedLaw>(law: L, u: u32, out: &mut CosSin<I1F31>) {
    *out = Fixed(law).warp(U0F32::from_bits(u));
}

/// Every operation of a law with a density in U0F32.
macro_rules! operations {
    ($keep:ident, $law:expr, $n:literal, $warp:ident, $quantile:ident, $cdf:ident, $pdf:ident, $density:ident, $unwarp:ident,
     $xorshift:ident, $pcg:ident) => {
        #[unsafe(no_mangle)]
        pub extern "C" fn $warp(u: u32, out: &mut CosSin<I1F31>) {
            warp($law, u, out);
        }
        #[unsafe(no_mangle)]
        pub extern "C" fn $quantile(p: u32) -> i32 {
            Fixed($law).quantile(U0F32::from_bits(p)).to_bits()
        }
        #[unsafe(no_mangle)]
        pub extern "C" fn $cdf(turn: i32) -> u32 {
            Fixed($law).cdf(I0F32::from_bits(turn)).to_bits()
        }
        #[unsafe(no_mangle)]
        pub extern "C" fn $pdf(turn: i32) -> u32 {
            Fixed($law).pdf(I0F32::from_bits(turn)).to_bits()
        }
        #[unsafe(no_mangle)]
        pub extern "C" fn $density(cos: i32, sin: i32) -> u32 {
            let (cos, sin) = (I1F31::from_bits(cos), I1F31::from_bits(sin));
            Fixed($law).density(CosSin { cos, sin }).to_bits()
        }
        #[unsafe(no_mangle)]
        pub extern "C" fn $unwarp(cos: i32, sin: i32) -> u32 {
            let (cos, sin) = (I1F31::from_bits(cos), I1F31::from_bits(sin));
            Fixed($law).unwarp(CosSin { cos, sin }).to_bits()
        }
        #[unsafe(no_mangle)]
        pub extern "C" fn $xorshift(rng: &mut Xorshift, out: &mut [I1F31; $n]) {
            *out = Fixed($law).sample(rng);
        }
        #[unsafe(no_mangle)]
        pub extern "C" fn $pcg(rng: &mut Pcg, out: &mut [I1F31; $n]) {
            *out = Fixed($law).sample(rng);
        }
        const $keep: [*const (); 8] = [
            $warp as *const (), $quantile as *const (), $cdf as *const (), $pdf as *const (), $density as *const (),
            $unwarp as *const (), $xorshift as *const (), $pcg as *const (),
        ];
    };
}
operations!(LAMBERT, Lambert, 3, lambert_warp, lambert_quantile, lambert_cdf, lambert_pdf, lambert_density, lambert_unwarp,
    lambert_sample_xorshift, lambert_sample_pcg);
operations!(SPHERE_SHELL, SphereShell, 3, sphere_shell_warp, sphere_shell_quantile, sphere_shell_cdf, sphere_shell_pdf,
    sphere_shell_density, sphere_shell_unwarp, sphere_shell_sample_xorshift, sphere_shell_sample_pcg);
operations!(BALL, Ball, 3, ball_warp, ball_quantile, ball_cdf, ball_pdf, ball_density, ball_unwarp,
    ball_sample_xorshift, ball_sample_pcg);
operations!(DISK, Disk, 2, disk_warp, disk_quantile, disk_cdf, disk_pdf, disk_density, disk_unwarp,
    disk_sample_xorshift, disk_sample_pcg);
operations!(CIRCLE_SHELL, CircleShell, 2, circle_shell_warp, circle_shell_quantile, circle_shell_cdf, circle_shell_pdf,
    circle_shell_density, circle_shell_unwarp, circle_shell_sample_xorshift, circle_shell_sample_pcg);
operations!(CIRCLE_ARC, CircleArc, 2, circle_arc_warp, circle_arc_quantile, circle_arc_cdf, circle_arc_pdf,
    circle_arc_density, circle_arc_unwarp, circle_arc_sample_xorshift, circle_arc_sample_pcg);

/// Refers to all of them, so that none is left out of the image.
#[unsafe(no_mangle)]
pub extern "C" fn _start() {
    let others = [empty as *const (), xorshift_word as *const (), pcg_word as *const (), turn_cos_sin as *const ()];
    core::hint::black_box((LAMBERT, SPHERE_SHELL, BALL, DISK, CIRCLE_SHELL, CIRCLE_ARC, others));
}
