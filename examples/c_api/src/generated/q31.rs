//! 32-bit integers: no floating-point instruction or routine is linked; made by tools/c_api.py, not by hand.

use crate::boundary::*;
use core::ffi::c_int;
use coslobe::Fixed;
use coslobe::integers::CosPower;
use coslobe::self_test;
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Lambert, SphereShell};
use fixed::types::{I0F32, I1F31, U0F32, U16F16};

fn plain(at: CosSin<I1F31>) -> Pair<i32> {
    Pair {
        cos: at.cos.to_bits(),
        sin: at.sin.to_bits(),
    }
}

fn pair(at: Pair<i32>) -> CosSin<I1F31> {
    CosSin {
        cos: I1F31::from_bits(at.cos),
        sin: I1F31::from_bits(at.sin),
    }
}

/// `coslobe_cos_power_q31` of the header.
pub type Lobe = Handle<Fixed<CosPower>, 10>;
const NO_PAIR: Pair<i32> = Pair { cos: 0, sin: 0 };

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_init_q31(law: *mut Lobe, exponent: u32) -> c_int {
    unsafe { init(law, Some(Fixed(CosPower::new(U16F16::from_bits(exponent))))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_sample_q31(
    rng: *const Generator,
    direction: *mut [i32; 2],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed(Disk).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_fill_q31(
    rng: *const Generator,
    directions: *mut [i32; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed(Disk).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_self_test_q31(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed(Disk))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_pdf_q31(theta: i32) -> u32 {
    Fixed(Disk).pdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_cdf_q31(theta: i32) -> u32 {
    Fixed(Disk).cdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_sf_q31(theta: i32) -> u32 {
    Fixed(Disk).sf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_quantile_q31(p: u32) -> i32 {
    Fixed(Disk).quantile(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_isf_q31(p: u32) -> i32 {
    Fixed(Disk).isf(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_warp_q31(p: u32) -> Pair<i32> {
    plain(Fixed(Disk).warp(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_warp_sf_q31(p: u32) -> Pair<i32> {
    plain(Fixed(Disk).warp_sf(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_unwarp_q31(at: Pair<i32>) -> u32 {
    Fixed(Disk).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_unwarp_sf_q31(at: Pair<i32>) -> u32 {
    Fixed(Disk).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_density_q31(at: Pair<i32>) -> u32 {
    Fixed(Disk).density(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_sample_q31(
    rng: *const Generator,
    direction: *mut [i32; 2],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed(CircleShell).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_fill_q31(
    rng: *const Generator,
    directions: *mut [i32; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed(CircleShell).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_self_test_q31(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed(CircleShell))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_pdf_q31(theta: i32) -> u32 {
    Fixed(CircleShell).pdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_cdf_q31(theta: i32) -> u32 {
    Fixed(CircleShell).cdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_sf_q31(theta: i32) -> u32 {
    Fixed(CircleShell).sf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_quantile_q31(p: u32) -> i32 {
    Fixed(CircleShell).quantile(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_isf_q31(p: u32) -> i32 {
    Fixed(CircleShell).isf(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_warp_q31(p: u32) -> Pair<i32> {
    plain(Fixed(CircleShell).warp(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_warp_sf_q31(p: u32) -> Pair<i32> {
    plain(Fixed(CircleShell).warp_sf(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_unwarp_q31(at: Pair<i32>) -> u32 {
    Fixed(CircleShell).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_unwarp_sf_q31(at: Pair<i32>) -> u32 {
    Fixed(CircleShell).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_density_q31(at: Pair<i32>) -> u32 {
    Fixed(CircleShell).density(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_sample_q31(
    rng: *const Generator,
    direction: *mut [i32; 2],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed(CircleArc).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_fill_q31(
    rng: *const Generator,
    directions: *mut [i32; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed(CircleArc).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_self_test_q31(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed(CircleArc))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_pdf_q31(theta: i32) -> u32 {
    Fixed(CircleArc).pdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_cdf_q31(theta: i32) -> u32 {
    Fixed(CircleArc).cdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_sf_q31(theta: i32) -> u32 {
    Fixed(CircleArc).sf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_quantile_q31(p: u32) -> i32 {
    Fixed(CircleArc).quantile(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_isf_q31(p: u32) -> i32 {
    Fixed(CircleArc).isf(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_warp_q31(p: u32) -> Pair<i32> {
    plain(Fixed(CircleArc).warp(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_warp_sf_q31(p: u32) -> Pair<i32> {
    plain(Fixed(CircleArc).warp_sf(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_unwarp_q31(at: Pair<i32>) -> u32 {
    Fixed(CircleArc).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_unwarp_sf_q31(at: Pair<i32>) -> u32 {
    Fixed(CircleArc).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_density_q31(at: Pair<i32>) -> u32 {
    Fixed(CircleArc).density(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_sample_q31(
    rng: *const Generator,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed(Ball).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_sample_around_q31(
    normal: *const [i32; 3],
    rng: *const Generator,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Fixed(Ball)
                .sample_around(normal.map(I1F31::from_bits), words)
                .map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_fill_q31(
    rng: *const Generator,
    directions: *mut [i32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed(Ball).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_warp_direction_q31(
    p: u32,
    turn: u32,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        put(
            direction,
            Fixed(Ball)
                .warp_direction([U0F32::from_bits(p), U0F32::from_bits(turn)])
                .map(|x| x.to_bits()),
        )
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_self_test_q31(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed(Ball))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_pdf_q31(theta: i32) -> u32 {
    Fixed(Ball).pdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_pdf_solid_angle_q31(theta: i32) -> u32 {
    Fixed(Ball)
        .pdf_solid_angle(I0F32::from_bits(theta))
        .to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_cdf_q31(theta: i32) -> u32 {
    Fixed(Ball).cdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_sf_q31(theta: i32) -> u32 {
    Fixed(Ball).sf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_quantile_q31(p: u32) -> i32 {
    Fixed(Ball).quantile(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_isf_q31(p: u32) -> i32 {
    Fixed(Ball).isf(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_warp_q31(p: u32) -> Pair<i32> {
    plain(Fixed(Ball).warp(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_warp_sf_q31(p: u32) -> Pair<i32> {
    plain(Fixed(Ball).warp_sf(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_unwarp_q31(at: Pair<i32>) -> u32 {
    Fixed(Ball).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_unwarp_sf_q31(at: Pair<i32>) -> u32 {
    Fixed(Ball).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_density_q31(at: Pair<i32>) -> u32 {
    Fixed(Ball).density(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_sample_q31(
    rng: *const Generator,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed(SphereShell).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_sample_around_q31(
    normal: *const [i32; 3],
    rng: *const Generator,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Fixed(SphereShell)
                .sample_around(normal.map(I1F31::from_bits), words)
                .map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_fill_q31(
    rng: *const Generator,
    directions: *mut [i32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed(SphereShell).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_warp_direction_q31(
    p: u32,
    turn: u32,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        put(
            direction,
            Fixed(SphereShell)
                .warp_direction([U0F32::from_bits(p), U0F32::from_bits(turn)])
                .map(|x| x.to_bits()),
        )
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_self_test_q31(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed(SphereShell))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_pdf_q31(theta: i32) -> u32 {
    Fixed(SphereShell).pdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_pdf_solid_angle_q31(theta: i32) -> u32 {
    Fixed(SphereShell)
        .pdf_solid_angle(I0F32::from_bits(theta))
        .to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_cdf_q31(theta: i32) -> u32 {
    Fixed(SphereShell).cdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_sf_q31(theta: i32) -> u32 {
    Fixed(SphereShell).sf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_quantile_q31(p: u32) -> i32 {
    Fixed(SphereShell).quantile(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_isf_q31(p: u32) -> i32 {
    Fixed(SphereShell).isf(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_warp_q31(p: u32) -> Pair<i32> {
    plain(Fixed(SphereShell).warp(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_warp_sf_q31(p: u32) -> Pair<i32> {
    plain(Fixed(SphereShell).warp_sf(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_unwarp_q31(at: Pair<i32>) -> u32 {
    Fixed(SphereShell).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_unwarp_sf_q31(at: Pair<i32>) -> u32 {
    Fixed(SphereShell).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_density_q31(at: Pair<i32>) -> u32 {
    Fixed(SphereShell).density(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_sample_q31(
    rng: *const Generator,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed(Lambert).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_sample_around_q31(
    normal: *const [i32; 3],
    rng: *const Generator,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Fixed(Lambert)
                .sample_around(normal.map(I1F31::from_bits), words)
                .map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_fill_q31(
    rng: *const Generator,
    directions: *mut [i32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed(Lambert).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_warp_direction_q31(
    p: u32,
    turn: u32,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        put(
            direction,
            Fixed(Lambert)
                .warp_direction([U0F32::from_bits(p), U0F32::from_bits(turn)])
                .map(|x| x.to_bits()),
        )
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_self_test_q31(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed(Lambert))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_pdf_q31(theta: i32) -> u32 {
    Fixed(Lambert).pdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_pdf_solid_angle_q31(theta: i32) -> u32 {
    Fixed(Lambert)
        .pdf_solid_angle(I0F32::from_bits(theta))
        .to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_cdf_q31(theta: i32) -> u32 {
    Fixed(Lambert).cdf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_sf_q31(theta: i32) -> u32 {
    Fixed(Lambert).sf(I0F32::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_quantile_q31(p: u32) -> i32 {
    Fixed(Lambert).quantile(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_isf_q31(p: u32) -> i32 {
    Fixed(Lambert).isf(U0F32::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_warp_q31(p: u32) -> Pair<i32> {
    plain(Fixed(Lambert).warp(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_warp_sf_q31(p: u32) -> Pair<i32> {
    plain(Fixed(Lambert).warp_sf(U0F32::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_unwarp_q31(at: Pair<i32>) -> u32 {
    Fixed(Lambert).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_unwarp_sf_q31(at: Pair<i32>) -> u32 {
    Fixed(Lambert).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_density_q31(at: Pair<i32>) -> u32 {
    Fixed(Lambert).density(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_sample_q31(
    law: *const Lobe,
    rng: *const Generator,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            draw(rng, direction, |words| {
                law.sample(words).map(|x| x.to_bits())
            })
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_sample_around_q31(
    law: *const Lobe,
    normal: *const [i32; 3],
    rng: *const Generator,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            around(normal, rng, direction, |normal, words| {
                law.sample_around(normal.map(I1F31::from_bits), words)
                    .map(|x| x.to_bits())
            })
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_fill_q31(
    law: *const Lobe,
    rng: *const Generator,
    directions: *mut [i32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            fill(rng, directions, n, filled, |words| {
                law.sample(words).map(|x| x.to_bits())
            })
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_warp_direction_q31(
    law: *const Lobe,
    p: u32,
    turn: u32,
    direction: *mut [i32; 3],
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            put(
                direction,
                law.warp_direction([U0F32::from_bits(p), U0F32::from_bits(turn)])
                    .map(|x| x.to_bits()),
            )
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_self_test_q31(
    law: *const Lobe,
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            judge(rng, fault, self_test::fixed(law))
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_pdf_q31(law: *const Lobe, theta: i32) -> u32 {
    unsafe { with(law, 0, |law| law.pdf(I0F32::from_bits(theta)).to_bits()) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_pdf_solid_angle_q31(
    law: *const Lobe,
    theta: i32,
) -> u32 {
    unsafe {
        with(law, 0, |law| {
            law.pdf_solid_angle(I0F32::from_bits(theta)).to_bits()
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_cdf_q31(law: *const Lobe, theta: i32) -> u32 {
    unsafe { with(law, 0, |law| law.cdf(I0F32::from_bits(theta)).to_bits()) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_sf_q31(law: *const Lobe, theta: i32) -> u32 {
    unsafe { with(law, 0, |law| law.sf(I0F32::from_bits(theta)).to_bits()) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_quantile_q31(law: *const Lobe, p: u32) -> i32 {
    unsafe { with(law, 0, |law| law.quantile(U0F32::from_bits(p)).to_bits()) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_isf_q31(law: *const Lobe, p: u32) -> i32 {
    unsafe { with(law, 0, |law| law.isf(U0F32::from_bits(p)).to_bits()) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_warp_q31(law: *const Lobe, p: u32) -> Pair<i32> {
    unsafe { with(law, NO_PAIR, |law| plain(law.warp(U0F32::from_bits(p)))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_warp_sf_q31(law: *const Lobe, p: u32) -> Pair<i32> {
    unsafe { with(law, NO_PAIR, |law| plain(law.warp_sf(U0F32::from_bits(p)))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_unwarp_q31(law: *const Lobe, at: Pair<i32>) -> u32 {
    unsafe { with(law, 0, |law| law.unwarp(pair(at)).to_bits()) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_unwarp_sf_q31(law: *const Lobe, at: Pair<i32>) -> u32 {
    unsafe { with(law, 0, |law| law.unwarp_sf(pair(at)).to_bits()) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_density_q31(law: *const Lobe, at: Pair<i32>) -> u32 {
    unsafe { with(law, 0, |law| law.density(pair(at)).to_bits()) }
}
