//! 16-bit integers: a third of the instructions on a Cortex-M0; made by tools/c_api.py, not by hand.

use crate::boundary::*;
use core::ffi::c_int;
use coslobe::Fixed16;
use coslobe::self_test;
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Lambert, SphereShell};
use fixed::types::{I0F16, I1F15, U0F16};

fn plain(at: CosSin<I1F15>) -> Pair<i16> {
    Pair {
        cos: at.cos.to_bits(),
        sin: at.sin.to_bits(),
    }
}

fn pair(at: Pair<i16>) -> CosSin<I1F15> {
    CosSin {
        cos: I1F15::from_bits(at.cos),
        sin: I1F15::from_bits(at.sin),
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_sample_q15(
    rng: *const Generator,
    direction: *mut [i16; 2],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed16(Disk).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_fill_q15(
    rng: *const Generator,
    directions: *mut [i16; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed16(Disk).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_self_test_q15(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed16(Disk))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_pdf_q15(theta: i16) -> u16 {
    Fixed16(Disk).pdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_cdf_q15(theta: i16) -> u16 {
    Fixed16(Disk).cdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_sf_q15(theta: i16) -> u16 {
    Fixed16(Disk).sf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_quantile_q15(p: u16) -> i16 {
    Fixed16(Disk).quantile(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_isf_q15(p: u16) -> i16 {
    Fixed16(Disk).isf(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_warp_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(Disk).warp(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_warp_sf_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(Disk).warp_sf(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_unwarp_q15(at: Pair<i16>) -> u16 {
    Fixed16(Disk).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_unwarp_sf_q15(at: Pair<i16>) -> u16 {
    Fixed16(Disk).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_density_q15(at: Pair<i16>) -> u16 {
    Fixed16(Disk).density(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_sample_q15(
    rng: *const Generator,
    direction: *mut [i16; 2],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed16(CircleShell).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_fill_q15(
    rng: *const Generator,
    directions: *mut [i16; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed16(CircleShell).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_self_test_q15(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed16(CircleShell))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_pdf_q15(theta: i16) -> u16 {
    Fixed16(CircleShell).pdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_cdf_q15(theta: i16) -> u16 {
    Fixed16(CircleShell).cdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_sf_q15(theta: i16) -> u16 {
    Fixed16(CircleShell).sf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_quantile_q15(p: u16) -> i16 {
    Fixed16(CircleShell).quantile(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_isf_q15(p: u16) -> i16 {
    Fixed16(CircleShell).isf(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_warp_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(CircleShell).warp(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_warp_sf_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(CircleShell).warp_sf(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_unwarp_q15(at: Pair<i16>) -> u16 {
    Fixed16(CircleShell).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_unwarp_sf_q15(at: Pair<i16>) -> u16 {
    Fixed16(CircleShell).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_density_q15(at: Pair<i16>) -> u16 {
    Fixed16(CircleShell).density(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_sample_q15(
    rng: *const Generator,
    direction: *mut [i16; 2],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed16(CircleArc).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_fill_q15(
    rng: *const Generator,
    directions: *mut [i16; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed16(CircleArc).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_self_test_q15(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed16(CircleArc))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_pdf_q15(theta: i16) -> u16 {
    Fixed16(CircleArc).pdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_cdf_q15(theta: i16) -> u16 {
    Fixed16(CircleArc).cdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_sf_q15(theta: i16) -> u16 {
    Fixed16(CircleArc).sf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_quantile_q15(p: u16) -> i16 {
    Fixed16(CircleArc).quantile(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_isf_q15(p: u16) -> i16 {
    Fixed16(CircleArc).isf(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_warp_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(CircleArc).warp(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_warp_sf_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(CircleArc).warp_sf(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_unwarp_q15(at: Pair<i16>) -> u16 {
    Fixed16(CircleArc).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_unwarp_sf_q15(at: Pair<i16>) -> u16 {
    Fixed16(CircleArc).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_density_q15(at: Pair<i16>) -> u16 {
    Fixed16(CircleArc).density(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_sample_q15(
    rng: *const Generator,
    direction: *mut [i16; 3],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed16(Ball).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_sample_around_q15(
    normal: *const [i16; 3],
    rng: *const Generator,
    direction: *mut [i16; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Fixed16(Ball)
                .sample_around(normal.map(I1F15::from_bits), words)
                .map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_fill_q15(
    rng: *const Generator,
    directions: *mut [i16; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed16(Ball).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_warp_direction_q15(
    p: u16,
    turn: u16,
    direction: *mut [i16; 3],
) -> c_int {
    unsafe {
        put(
            direction,
            Fixed16(Ball)
                .warp_direction([U0F16::from_bits(p), U0F16::from_bits(turn)])
                .map(|x| x.to_bits()),
        )
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_self_test_q15(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed16(Ball))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_pdf_q15(theta: i16) -> u16 {
    Fixed16(Ball).pdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_pdf_solid_angle_q15(theta: i16) -> u16 {
    Fixed16(Ball)
        .pdf_solid_angle(I0F16::from_bits(theta))
        .to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_cdf_q15(theta: i16) -> u16 {
    Fixed16(Ball).cdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_sf_q15(theta: i16) -> u16 {
    Fixed16(Ball).sf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_quantile_q15(p: u16) -> i16 {
    Fixed16(Ball).quantile(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_isf_q15(p: u16) -> i16 {
    Fixed16(Ball).isf(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_warp_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(Ball).warp(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_warp_sf_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(Ball).warp_sf(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_unwarp_q15(at: Pair<i16>) -> u16 {
    Fixed16(Ball).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_unwarp_sf_q15(at: Pair<i16>) -> u16 {
    Fixed16(Ball).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_density_q15(at: Pair<i16>) -> u16 {
    Fixed16(Ball).density(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_sample_q15(
    rng: *const Generator,
    direction: *mut [i16; 3],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed16(SphereShell).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_sample_around_q15(
    normal: *const [i16; 3],
    rng: *const Generator,
    direction: *mut [i16; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Fixed16(SphereShell)
                .sample_around(normal.map(I1F15::from_bits), words)
                .map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_fill_q15(
    rng: *const Generator,
    directions: *mut [i16; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed16(SphereShell).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_warp_direction_q15(
    p: u16,
    turn: u16,
    direction: *mut [i16; 3],
) -> c_int {
    unsafe {
        put(
            direction,
            Fixed16(SphereShell)
                .warp_direction([U0F16::from_bits(p), U0F16::from_bits(turn)])
                .map(|x| x.to_bits()),
        )
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_self_test_q15(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed16(SphereShell))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_pdf_q15(theta: i16) -> u16 {
    Fixed16(SphereShell).pdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_pdf_solid_angle_q15(theta: i16) -> u16 {
    Fixed16(SphereShell)
        .pdf_solid_angle(I0F16::from_bits(theta))
        .to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_cdf_q15(theta: i16) -> u16 {
    Fixed16(SphereShell).cdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_sf_q15(theta: i16) -> u16 {
    Fixed16(SphereShell).sf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_quantile_q15(p: u16) -> i16 {
    Fixed16(SphereShell).quantile(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_isf_q15(p: u16) -> i16 {
    Fixed16(SphereShell).isf(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_warp_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(SphereShell).warp(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_warp_sf_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(SphereShell).warp_sf(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_unwarp_q15(at: Pair<i16>) -> u16 {
    Fixed16(SphereShell).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_unwarp_sf_q15(at: Pair<i16>) -> u16 {
    Fixed16(SphereShell).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_density_q15(at: Pair<i16>) -> u16 {
    Fixed16(SphereShell).density(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_sample_q15(
    rng: *const Generator,
    direction: *mut [i16; 3],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Fixed16(Lambert).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_sample_around_q15(
    normal: *const [i16; 3],
    rng: *const Generator,
    direction: *mut [i16; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Fixed16(Lambert)
                .sample_around(normal.map(I1F15::from_bits), words)
                .map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_fill_q15(
    rng: *const Generator,
    directions: *mut [i16; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Fixed16(Lambert).sample(words).map(|x| x.to_bits())
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_warp_direction_q15(
    p: u16,
    turn: u16,
    direction: *mut [i16; 3],
) -> c_int {
    unsafe {
        put(
            direction,
            Fixed16(Lambert)
                .warp_direction([U0F16::from_bits(p), U0F16::from_bits(turn)])
                .map(|x| x.to_bits()),
        )
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_self_test_q15(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::fixed(Fixed16(Lambert))) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_pdf_q15(theta: i16) -> u16 {
    Fixed16(Lambert).pdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_pdf_solid_angle_q15(theta: i16) -> u16 {
    Fixed16(Lambert)
        .pdf_solid_angle(I0F16::from_bits(theta))
        .to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_cdf_q15(theta: i16) -> u16 {
    Fixed16(Lambert).cdf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_sf_q15(theta: i16) -> u16 {
    Fixed16(Lambert).sf(I0F16::from_bits(theta)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_quantile_q15(p: u16) -> i16 {
    Fixed16(Lambert).quantile(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_isf_q15(p: u16) -> i16 {
    Fixed16(Lambert).isf(U0F16::from_bits(p)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_warp_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(Lambert).warp(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_warp_sf_q15(p: u16) -> Pair<i16> {
    plain(Fixed16(Lambert).warp_sf(U0F16::from_bits(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_unwarp_q15(at: Pair<i16>) -> u16 {
    Fixed16(Lambert).unwarp(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_unwarp_sf_q15(at: Pair<i16>) -> u16 {
    Fixed16(Lambert).unwarp_sf(pair(at)).to_bits()
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_density_q15(at: Pair<i16>) -> u16 {
    Fixed16(Lambert).density(pair(at)).to_bits()
}
