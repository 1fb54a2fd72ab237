//! Float: at most 4 units in the last place off; made by tools/c_api.py, not by hand.

use crate::boundary::*;
use core::ffi::c_int;
use coslobe::self_test;
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Lambert, SphereShell};
use coslobe::{CosPower, Law, Planar, PlanarPoint, Radius, Spatial, SpatialPoint};

fn plain(at: CosSin<f32>) -> Pair<f32> {
    Pair {
        cos: at.cos,
        sin: at.sin,
    }
}

fn pair(at: Pair<f32>) -> CosSin<f32> {
    CosSin {
        cos: at.cos,
        sin: at.sin,
    }
}

/// `coslobe_cos_power_f32` of the header.
pub type Lobe = Handle<CosPower<f32>, 24>;
const NONE: f32 = f32::NAN;
const NO_PAIR: Pair<f32> = Pair {
    cos: f32::NAN,
    sin: f32::NAN,
};

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_init_f32(law: *mut Lobe, exponent: f32) -> c_int {
    unsafe { init(law, CosPower::new(exponent).ok()) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_sample_f32(
    rng: *const Generator,
    direction: *mut [f32; 2],
) -> c_int {
    unsafe { draw(rng, direction, |words| Planar::sample(&Disk, words)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_fill_f32(
    rng: *const Generator,
    directions: *mut [f32; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Planar::sample(&Disk, words)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_point_f32(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 2],
) -> c_int {
    unsafe {
        match Radius::new(radius) {
            Ok(radius) => draw(rng, point, |words| {
                PlanarPoint::sample_point(&Disk, radius, words)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_self_test_f32(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::planar::<f32, _>(Disk)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_pdf_f32(theta: f32) -> f32 {
    Law::pdf(&Disk, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_ln_pdf_f32(theta: f32) -> f32 {
    Law::ln_pdf(&Disk, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_cdf_f32(theta: f32) -> f32 {
    Law::cdf(&Disk, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_sf_f32(theta: f32) -> f32 {
    Law::sf(&Disk, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_quantile_f32(p: f32) -> f32 {
    Law::quantile(&Disk, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_isf_f32(p: f32) -> f32 {
    Law::isf(&Disk, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_warp_f32(p: f32) -> Pair<f32> {
    plain(Law::warp(&Disk, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_warp_sf_f32(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&Disk, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_unwarp_f32(at: Pair<f32>) -> f32 {
    Law::unwarp(&Disk, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_unwarp_sf_f32(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&Disk, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_density_f32(at: Pair<f32>) -> f32 {
    Law::density(&Disk, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_lambert_weight_f32(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&Disk, pair(at))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_sample_f32(
    rng: *const Generator,
    direction: *mut [f32; 2],
) -> c_int {
    unsafe { draw(rng, direction, |words| Planar::sample(&CircleShell, words)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_fill_f32(
    rng: *const Generator,
    directions: *mut [f32; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Planar::sample(&CircleShell, words)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_point_f32(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 2],
) -> c_int {
    unsafe {
        match Radius::new(radius) {
            Ok(radius) => draw(rng, point, |words| {
                PlanarPoint::sample_point(&CircleShell, radius, words)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_self_test_f32(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::planar::<f32, _>(CircleShell)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_pdf_f32(theta: f32) -> f32 {
    Law::pdf(&CircleShell, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_ln_pdf_f32(theta: f32) -> f32 {
    Law::ln_pdf(&CircleShell, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_cdf_f32(theta: f32) -> f32 {
    Law::cdf(&CircleShell, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_sf_f32(theta: f32) -> f32 {
    Law::sf(&CircleShell, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_quantile_f32(p: f32) -> f32 {
    Law::quantile(&CircleShell, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_isf_f32(p: f32) -> f32 {
    Law::isf(&CircleShell, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_warp_f32(p: f32) -> Pair<f32> {
    plain(Law::warp(&CircleShell, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_warp_sf_f32(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&CircleShell, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_unwarp_f32(at: Pair<f32>) -> f32 {
    Law::unwarp(&CircleShell, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_unwarp_sf_f32(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&CircleShell, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_density_f32(at: Pair<f32>) -> f32 {
    Law::density(&CircleShell, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_lambert_weight_f32(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&CircleShell, pair(at))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_sample_f32(
    rng: *const Generator,
    direction: *mut [f32; 2],
) -> c_int {
    unsafe { draw(rng, direction, |words| Planar::sample(&CircleArc, words)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_fill_f32(
    rng: *const Generator,
    directions: *mut [f32; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Planar::sample(&CircleArc, words)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_point_f32(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 2],
) -> c_int {
    unsafe {
        match Radius::new(radius) {
            Ok(radius) => draw(rng, point, |words| {
                PlanarPoint::sample_point(&CircleArc, radius, words)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_self_test_f32(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::planar::<f32, _>(CircleArc)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_pdf_f32(theta: f32) -> f32 {
    Law::pdf(&CircleArc, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_ln_pdf_f32(theta: f32) -> f32 {
    Law::ln_pdf(&CircleArc, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_cdf_f32(theta: f32) -> f32 {
    Law::cdf(&CircleArc, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_sf_f32(theta: f32) -> f32 {
    Law::sf(&CircleArc, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_quantile_f32(p: f32) -> f32 {
    Law::quantile(&CircleArc, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_isf_f32(p: f32) -> f32 {
    Law::isf(&CircleArc, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_warp_f32(p: f32) -> Pair<f32> {
    plain(Law::warp(&CircleArc, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_warp_sf_f32(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&CircleArc, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_unwarp_f32(at: Pair<f32>) -> f32 {
    Law::unwarp(&CircleArc, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_unwarp_sf_f32(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&CircleArc, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_density_f32(at: Pair<f32>) -> f32 {
    Law::density(&CircleArc, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_lambert_weight_f32(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&CircleArc, pair(at))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_sample_f32(
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe { draw(rng, direction, |words| Spatial::sample(&Ball, words)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_sample_around_f32(
    normal: *const [f32; 3],
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Spatial::sample_around(&Ball, normal, words)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_fill_f32(
    rng: *const Generator,
    directions: *mut [f32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Spatial::sample(&Ball, words)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_warp_direction_f32(
    p: f32,
    turn: f32,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe { put(direction, Spatial::warp_direction(&Ball, [p, turn])) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_point_f32(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 3],
) -> c_int {
    unsafe {
        match Radius::new(radius) {
            Ok(radius) => draw(rng, point, |words| {
                SpatialPoint::sample_point(&Ball, radius, words)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_self_test_f32(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::spatial::<f32, _>(Ball)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_pdf_f32(theta: f32) -> f32 {
    Law::pdf(&Ball, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_ln_pdf_f32(theta: f32) -> f32 {
    Law::ln_pdf(&Ball, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_pdf_solid_angle_f32(theta: f32) -> f32 {
    Spatial::pdf_solid_angle(&Ball, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_cdf_f32(theta: f32) -> f32 {
    Law::cdf(&Ball, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_sf_f32(theta: f32) -> f32 {
    Law::sf(&Ball, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_quantile_f32(p: f32) -> f32 {
    Law::quantile(&Ball, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_isf_f32(p: f32) -> f32 {
    Law::isf(&Ball, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_warp_f32(p: f32) -> Pair<f32> {
    plain(Law::warp(&Ball, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_warp_sf_f32(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&Ball, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_unwarp_f32(at: Pair<f32>) -> f32 {
    Law::unwarp(&Ball, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_unwarp_sf_f32(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&Ball, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_density_f32(at: Pair<f32>) -> f32 {
    Law::density(&Ball, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_lambert_weight_f32(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&Ball, pair(at))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_sample_f32(
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe { draw(rng, direction, |words| Spatial::sample(&SphereShell, words)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_sample_around_f32(
    normal: *const [f32; 3],
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Spatial::sample_around(&SphereShell, normal, words)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_fill_f32(
    rng: *const Generator,
    directions: *mut [f32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Spatial::sample(&SphereShell, words)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_warp_direction_f32(
    p: f32,
    turn: f32,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe { put(direction, Spatial::warp_direction(&SphereShell, [p, turn])) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_point_f32(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 3],
) -> c_int {
    unsafe {
        match Radius::new(radius) {
            Ok(radius) => draw(rng, point, |words| {
                SpatialPoint::sample_point(&SphereShell, radius, words)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_self_test_f32(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::spatial::<f32, _>(SphereShell)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_pdf_f32(theta: f32) -> f32 {
    Law::pdf(&SphereShell, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_ln_pdf_f32(theta: f32) -> f32 {
    Law::ln_pdf(&SphereShell, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_pdf_solid_angle_f32(theta: f32) -> f32 {
    Spatial::pdf_solid_angle(&SphereShell, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_cdf_f32(theta: f32) -> f32 {
    Law::cdf(&SphereShell, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_sf_f32(theta: f32) -> f32 {
    Law::sf(&SphereShell, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_quantile_f32(p: f32) -> f32 {
    Law::quantile(&SphereShell, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_isf_f32(p: f32) -> f32 {
    Law::isf(&SphereShell, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_warp_f32(p: f32) -> Pair<f32> {
    plain(Law::warp(&SphereShell, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_warp_sf_f32(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&SphereShell, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_unwarp_f32(at: Pair<f32>) -> f32 {
    Law::unwarp(&SphereShell, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_unwarp_sf_f32(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&SphereShell, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_density_f32(at: Pair<f32>) -> f32 {
    Law::density(&SphereShell, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_lambert_weight_f32(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&SphereShell, pair(at))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_sample_f32(
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe { draw(rng, direction, |words| Spatial::sample(&Lambert, words)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_sample_around_f32(
    normal: *const [f32; 3],
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Spatial::sample_around(&Lambert, normal, words)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_fill_f32(
    rng: *const Generator,
    directions: *mut [f32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Spatial::sample(&Lambert, words)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_warp_direction_f32(
    p: f32,
    turn: f32,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe { put(direction, Spatial::warp_direction(&Lambert, [p, turn])) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_point_f32(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 3],
) -> c_int {
    unsafe {
        match Radius::new(radius) {
            Ok(radius) => draw(rng, point, |words| {
                SpatialPoint::sample_point(&Lambert, radius, words)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_self_test_f32(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::spatial::<f32, _>(Lambert)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_pdf_f32(theta: f32) -> f32 {
    Law::pdf(&Lambert, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_ln_pdf_f32(theta: f32) -> f32 {
    Law::ln_pdf(&Lambert, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_pdf_solid_angle_f32(theta: f32) -> f32 {
    Spatial::pdf_solid_angle(&Lambert, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_cdf_f32(theta: f32) -> f32 {
    Law::cdf(&Lambert, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_sf_f32(theta: f32) -> f32 {
    Law::sf(&Lambert, theta)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_quantile_f32(p: f32) -> f32 {
    Law::quantile(&Lambert, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_isf_f32(p: f32) -> f32 {
    Law::isf(&Lambert, p)
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_warp_f32(p: f32) -> Pair<f32> {
    plain(Law::warp(&Lambert, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_warp_sf_f32(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&Lambert, p))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_unwarp_f32(at: Pair<f32>) -> f32 {
    Law::unwarp(&Lambert, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_unwarp_sf_f32(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&Lambert, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_density_f32(at: Pair<f32>) -> f32 {
    Law::density(&Lambert, pair(at))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_lambert_weight_f32(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&Lambert, pair(at))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_sample_f32(
    law: *const Lobe,
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            draw(rng, direction, |words| Spatial::sample(&law, words))
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_sample_around_f32(
    law: *const Lobe,
    normal: *const [f32; 3],
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            around(normal, rng, direction, |normal, words| {
                Spatial::sample_around(&law, normal, words)
            })
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_fill_f32(
    law: *const Lobe,
    rng: *const Generator,
    directions: *mut [f32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            fill(rng, directions, n, filled, |words| {
                Spatial::sample(&law, words)
            })
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_warp_direction_f32(
    law: *const Lobe,
    p: f32,
    turn: f32,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            put(direction, Spatial::warp_direction(&law, [p, turn]))
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_self_test_f32(
    law: *const Lobe,
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            judge(rng, fault, self_test::spatial::<f32, _>(law))
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_pdf_f32(law: *const Lobe, theta: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::pdf(&law, theta)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_ln_pdf_f32(law: *const Lobe, theta: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::ln_pdf(&law, theta)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_pdf_solid_angle_f32(
    law: *const Lobe,
    theta: f32,
) -> f32 {
    unsafe { with(law, NONE, |law| Spatial::pdf_solid_angle(&law, theta)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_cdf_f32(law: *const Lobe, theta: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::cdf(&law, theta)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_sf_f32(law: *const Lobe, theta: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::sf(&law, theta)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_quantile_f32(law: *const Lobe, p: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::quantile(&law, p)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_isf_f32(law: *const Lobe, p: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::isf(&law, p)) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_warp_f32(law: *const Lobe, p: f32) -> Pair<f32> {
    unsafe { with(law, NO_PAIR, |law| plain(Law::warp(&law, p))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_warp_sf_f32(law: *const Lobe, p: f32) -> Pair<f32> {
    unsafe { with(law, NO_PAIR, |law| plain(Law::warp_sf(&law, p))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_unwarp_f32(law: *const Lobe, at: Pair<f32>) -> f32 {
    unsafe { with(law, NONE, |law| Law::unwarp(&law, pair(at))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_unwarp_sf_f32(law: *const Lobe, at: Pair<f32>) -> f32 {
    unsafe { with(law, NONE, |law| Law::unwarp_sf(&law, pair(at))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_density_f32(law: *const Lobe, at: Pair<f32>) -> f32 {
    unsafe { with(law, NONE, |law| Law::density(&law, pair(at))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_lambert_weight_f32(
    law: *const Lobe,
    at: Pair<f32>,
) -> f32 {
    unsafe { with(law, NONE, |law| Law::lambert_weight(&law, pair(at))) }
}
