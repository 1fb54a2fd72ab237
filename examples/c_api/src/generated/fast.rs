//! Float to half its digits (relative error 2^-12): cheaper without an FPU; made by tools/c_api.py, not by hand.

use crate::boundary::*;
use core::ffi::c_int;
use coslobe::Fast;
use coslobe::self_test;
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Lambert, SphereShell};
use coslobe::{CosPower, Law, Planar, PlanarPoint, Radius, Spatial, SpatialPoint};

fn plain(at: CosSin<Fast<f32>>) -> Pair<f32> {
    Pair {
        cos: at.cos.0,
        sin: at.sin.0,
    }
}

fn pair(at: Pair<f32>) -> CosSin<Fast<f32>> {
    CosSin {
        cos: Fast(at.cos),
        sin: Fast(at.sin),
    }
}

/// `coslobe_cos_power_fast` of the header.
pub type Lobe = Handle<CosPower<Fast<f32>>, 24>;
const NONE: f32 = f32::NAN;
const NO_PAIR: Pair<f32> = Pair {
    cos: f32::NAN,
    sin: f32::NAN,
};

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_init_fast(law: *mut Lobe, exponent: f32) -> c_int {
    unsafe { init(law, CosPower::new(Fast(exponent)).ok()) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_sample_fast(
    rng: *const Generator,
    direction: *mut [f32; 2],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Planar::sample(&Disk, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_fill_fast(
    rng: *const Generator,
    directions: *mut [f32; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Planar::sample(&Disk, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_point_fast(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 2],
) -> c_int {
    unsafe {
        match Radius::new(Fast(radius)) {
            Ok(radius) => draw(rng, point, |words| {
                PlanarPoint::sample_point(&Disk, radius, words).map(|x: Fast<f32>| x.0)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_disk_self_test_fast(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::planar::<Fast<f32>, _>(Disk)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_pdf_fast(theta: f32) -> f32 {
    Law::pdf(&Disk, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_ln_pdf_fast(theta: f32) -> f32 {
    Law::ln_pdf(&Disk, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_cdf_fast(theta: f32) -> f32 {
    Law::cdf(&Disk, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_sf_fast(theta: f32) -> f32 {
    Law::sf(&Disk, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_quantile_fast(p: f32) -> f32 {
    Law::quantile(&Disk, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_isf_fast(p: f32) -> f32 {
    Law::isf(&Disk, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_warp_fast(p: f32) -> Pair<f32> {
    plain(Law::warp(&Disk, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_warp_sf_fast(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&Disk, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_unwarp_fast(at: Pair<f32>) -> f32 {
    Law::unwarp(&Disk, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_unwarp_sf_fast(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&Disk, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_density_fast(at: Pair<f32>) -> f32 {
    Law::density(&Disk, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_disk_lambert_weight_fast(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&Disk, pair(at)).0
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_sample_fast(
    rng: *const Generator,
    direction: *mut [f32; 2],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Planar::sample(&CircleShell, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_fill_fast(
    rng: *const Generator,
    directions: *mut [f32; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Planar::sample(&CircleShell, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_point_fast(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 2],
) -> c_int {
    unsafe {
        match Radius::new(Fast(radius)) {
            Ok(radius) => draw(rng, point, |words| {
                PlanarPoint::sample_point(&CircleShell, radius, words).map(|x: Fast<f32>| x.0)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_shell_self_test_fast(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::planar::<Fast<f32>, _>(CircleShell)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_pdf_fast(theta: f32) -> f32 {
    Law::pdf(&CircleShell, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_ln_pdf_fast(theta: f32) -> f32 {
    Law::ln_pdf(&CircleShell, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_cdf_fast(theta: f32) -> f32 {
    Law::cdf(&CircleShell, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_sf_fast(theta: f32) -> f32 {
    Law::sf(&CircleShell, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_quantile_fast(p: f32) -> f32 {
    Law::quantile(&CircleShell, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_isf_fast(p: f32) -> f32 {
    Law::isf(&CircleShell, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_warp_fast(p: f32) -> Pair<f32> {
    plain(Law::warp(&CircleShell, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_warp_sf_fast(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&CircleShell, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_unwarp_fast(at: Pair<f32>) -> f32 {
    Law::unwarp(&CircleShell, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_unwarp_sf_fast(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&CircleShell, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_density_fast(at: Pair<f32>) -> f32 {
    Law::density(&CircleShell, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_shell_lambert_weight_fast(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&CircleShell, pair(at)).0
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_sample_fast(
    rng: *const Generator,
    direction: *mut [f32; 2],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Planar::sample(&CircleArc, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_fill_fast(
    rng: *const Generator,
    directions: *mut [f32; 2],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Planar::sample(&CircleArc, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_point_fast(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 2],
) -> c_int {
    unsafe {
        match Radius::new(Fast(radius)) {
            Ok(radius) => draw(rng, point, |words| {
                PlanarPoint::sample_point(&CircleArc, radius, words).map(|x: Fast<f32>| x.0)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_circle_arc_self_test_fast(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::planar::<Fast<f32>, _>(CircleArc)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_pdf_fast(theta: f32) -> f32 {
    Law::pdf(&CircleArc, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_ln_pdf_fast(theta: f32) -> f32 {
    Law::ln_pdf(&CircleArc, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_cdf_fast(theta: f32) -> f32 {
    Law::cdf(&CircleArc, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_sf_fast(theta: f32) -> f32 {
    Law::sf(&CircleArc, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_quantile_fast(p: f32) -> f32 {
    Law::quantile(&CircleArc, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_isf_fast(p: f32) -> f32 {
    Law::isf(&CircleArc, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_warp_fast(p: f32) -> Pair<f32> {
    plain(Law::warp(&CircleArc, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_warp_sf_fast(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&CircleArc, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_unwarp_fast(at: Pair<f32>) -> f32 {
    Law::unwarp(&CircleArc, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_unwarp_sf_fast(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&CircleArc, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_density_fast(at: Pair<f32>) -> f32 {
    Law::density(&CircleArc, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_circle_arc_lambert_weight_fast(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&CircleArc, pair(at)).0
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_sample_fast(
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Spatial::sample(&Ball, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_sample_around_fast(
    normal: *const [f32; 3],
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Spatial::sample_around(&Ball, normal.map(Fast), words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_fill_fast(
    rng: *const Generator,
    directions: *mut [f32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Spatial::sample(&Ball, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_warp_direction_fast(
    p: f32,
    turn: f32,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        put(
            direction,
            Spatial::warp_direction(&Ball, [Fast(p), Fast(turn)]).map(|x: Fast<f32>| x.0),
        )
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_point_fast(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 3],
) -> c_int {
    unsafe {
        match Radius::new(Fast(radius)) {
            Ok(radius) => draw(rng, point, |words| {
                SpatialPoint::sample_point(&Ball, radius, words).map(|x: Fast<f32>| x.0)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_ball_self_test_fast(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::spatial::<Fast<f32>, _>(Ball)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_pdf_fast(theta: f32) -> f32 {
    Law::pdf(&Ball, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_ln_pdf_fast(theta: f32) -> f32 {
    Law::ln_pdf(&Ball, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_pdf_solid_angle_fast(theta: f32) -> f32 {
    Spatial::pdf_solid_angle(&Ball, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_cdf_fast(theta: f32) -> f32 {
    Law::cdf(&Ball, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_sf_fast(theta: f32) -> f32 {
    Law::sf(&Ball, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_quantile_fast(p: f32) -> f32 {
    Law::quantile(&Ball, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_isf_fast(p: f32) -> f32 {
    Law::isf(&Ball, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_warp_fast(p: f32) -> Pair<f32> {
    plain(Law::warp(&Ball, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_warp_sf_fast(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&Ball, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_unwarp_fast(at: Pair<f32>) -> f32 {
    Law::unwarp(&Ball, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_unwarp_sf_fast(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&Ball, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_density_fast(at: Pair<f32>) -> f32 {
    Law::density(&Ball, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_ball_lambert_weight_fast(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&Ball, pair(at)).0
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_sample_fast(
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Spatial::sample(&SphereShell, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_sample_around_fast(
    normal: *const [f32; 3],
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Spatial::sample_around(&SphereShell, normal.map(Fast), words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_fill_fast(
    rng: *const Generator,
    directions: *mut [f32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Spatial::sample(&SphereShell, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_warp_direction_fast(
    p: f32,
    turn: f32,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        put(
            direction,
            Spatial::warp_direction(&SphereShell, [Fast(p), Fast(turn)]).map(|x: Fast<f32>| x.0),
        )
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_point_fast(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 3],
) -> c_int {
    unsafe {
        match Radius::new(Fast(radius)) {
            Ok(radius) => draw(rng, point, |words| {
                SpatialPoint::sample_point(&SphereShell, radius, words).map(|x: Fast<f32>| x.0)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_sphere_shell_self_test_fast(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::spatial::<Fast<f32>, _>(SphereShell)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_pdf_fast(theta: f32) -> f32 {
    Law::pdf(&SphereShell, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_ln_pdf_fast(theta: f32) -> f32 {
    Law::ln_pdf(&SphereShell, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_pdf_solid_angle_fast(theta: f32) -> f32 {
    Spatial::pdf_solid_angle(&SphereShell, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_cdf_fast(theta: f32) -> f32 {
    Law::cdf(&SphereShell, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_sf_fast(theta: f32) -> f32 {
    Law::sf(&SphereShell, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_quantile_fast(p: f32) -> f32 {
    Law::quantile(&SphereShell, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_isf_fast(p: f32) -> f32 {
    Law::isf(&SphereShell, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_warp_fast(p: f32) -> Pair<f32> {
    plain(Law::warp(&SphereShell, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_warp_sf_fast(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&SphereShell, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_unwarp_fast(at: Pair<f32>) -> f32 {
    Law::unwarp(&SphereShell, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_unwarp_sf_fast(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&SphereShell, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_density_fast(at: Pair<f32>) -> f32 {
    Law::density(&SphereShell, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_sphere_shell_lambert_weight_fast(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&SphereShell, pair(at)).0
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_sample_fast(
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        draw(rng, direction, |words| {
            Spatial::sample(&Lambert, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_sample_around_fast(
    normal: *const [f32; 3],
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        around(normal, rng, direction, |normal, words| {
            Spatial::sample_around(&Lambert, normal.map(Fast), words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_fill_fast(
    rng: *const Generator,
    directions: *mut [f32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        fill(rng, directions, n, filled, |words| {
            Spatial::sample(&Lambert, words).map(|x: Fast<f32>| x.0)
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_warp_direction_fast(
    p: f32,
    turn: f32,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        put(
            direction,
            Spatial::warp_direction(&Lambert, [Fast(p), Fast(turn)]).map(|x: Fast<f32>| x.0),
        )
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_point_fast(
    radius: f32,
    rng: *const Generator,
    point: *mut [f32; 3],
) -> c_int {
    unsafe {
        match Radius::new(Fast(radius)) {
            Ok(radius) => draw(rng, point, |words| {
                SpatialPoint::sample_point(&Lambert, radius, words).map(|x: Fast<f32>| x.0)
            }),
            Err(_) => RADIUS,
        }
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_lambert_self_test_fast(
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe { judge(rng, fault, self_test::spatial::<Fast<f32>, _>(Lambert)) }
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_pdf_fast(theta: f32) -> f32 {
    Law::pdf(&Lambert, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_ln_pdf_fast(theta: f32) -> f32 {
    Law::ln_pdf(&Lambert, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_pdf_solid_angle_fast(theta: f32) -> f32 {
    Spatial::pdf_solid_angle(&Lambert, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_cdf_fast(theta: f32) -> f32 {
    Law::cdf(&Lambert, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_sf_fast(theta: f32) -> f32 {
    Law::sf(&Lambert, Fast(theta)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_quantile_fast(p: f32) -> f32 {
    Law::quantile(&Lambert, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_isf_fast(p: f32) -> f32 {
    Law::isf(&Lambert, Fast(p)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_warp_fast(p: f32) -> Pair<f32> {
    plain(Law::warp(&Lambert, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_warp_sf_fast(p: f32) -> Pair<f32> {
    plain(Law::warp_sf(&Lambert, Fast(p)))
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_unwarp_fast(at: Pair<f32>) -> f32 {
    Law::unwarp(&Lambert, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_unwarp_sf_fast(at: Pair<f32>) -> f32 {
    Law::unwarp_sf(&Lambert, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_density_fast(at: Pair<f32>) -> f32 {
    Law::density(&Lambert, pair(at)).0
}

#[unsafe(no_mangle)]
pub extern "C" fn coslobe_lambert_lambert_weight_fast(at: Pair<f32>) -> f32 {
    Law::lambert_weight(&Lambert, pair(at)).0
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_sample_fast(
    law: *const Lobe,
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            draw(rng, direction, |words| {
                Spatial::sample(&law, words).map(|x: Fast<f32>| x.0)
            })
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_sample_around_fast(
    law: *const Lobe,
    normal: *const [f32; 3],
    rng: *const Generator,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            around(normal, rng, direction, |normal, words| {
                Spatial::sample_around(&law, normal.map(Fast), words).map(|x: Fast<f32>| x.0)
            })
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_fill_fast(
    law: *const Lobe,
    rng: *const Generator,
    directions: *mut [f32; 3],
    n: usize,
    filled: *mut usize,
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            fill(rng, directions, n, filled, |words| {
                Spatial::sample(&law, words).map(|x: Fast<f32>| x.0)
            })
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_warp_direction_fast(
    law: *const Lobe,
    p: f32,
    turn: f32,
    direction: *mut [f32; 3],
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            put(
                direction,
                Spatial::warp_direction(&law, [Fast(p), Fast(turn)]).map(|x: Fast<f32>| x.0),
            )
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_self_test_fast(
    law: *const Lobe,
    rng: *const Generator,
    fault: *mut CFault,
) -> c_int {
    unsafe {
        with(law, NULL_POINTER, |law| {
            judge(rng, fault, self_test::spatial::<Fast<f32>, _>(law))
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_pdf_fast(law: *const Lobe, theta: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::pdf(&law, Fast(theta)).0) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_ln_pdf_fast(law: *const Lobe, theta: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::ln_pdf(&law, Fast(theta)).0) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_pdf_solid_angle_fast(
    law: *const Lobe,
    theta: f32,
) -> f32 {
    unsafe {
        with(law, NONE, |law| {
            Spatial::pdf_solid_angle(&law, Fast(theta)).0
        })
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_cdf_fast(law: *const Lobe, theta: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::cdf(&law, Fast(theta)).0) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_sf_fast(law: *const Lobe, theta: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::sf(&law, Fast(theta)).0) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_quantile_fast(law: *const Lobe, p: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::quantile(&law, Fast(p)).0) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_isf_fast(law: *const Lobe, p: f32) -> f32 {
    unsafe { with(law, NONE, |law| Law::isf(&law, Fast(p)).0) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_warp_fast(law: *const Lobe, p: f32) -> Pair<f32> {
    unsafe { with(law, NO_PAIR, |law| plain(Law::warp(&law, Fast(p)))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_warp_sf_fast(law: *const Lobe, p: f32) -> Pair<f32> {
    unsafe { with(law, NO_PAIR, |law| plain(Law::warp_sf(&law, Fast(p)))) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_unwarp_fast(law: *const Lobe, at: Pair<f32>) -> f32 {
    unsafe { with(law, NONE, |law| Law::unwarp(&law, pair(at)).0) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_unwarp_sf_fast(law: *const Lobe, at: Pair<f32>) -> f32 {
    unsafe { with(law, NONE, |law| Law::unwarp_sf(&law, pair(at)).0) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_density_fast(law: *const Lobe, at: Pair<f32>) -> f32 {
    unsafe { with(law, NONE, |law| Law::density(&law, pair(at)).0) }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn coslobe_cos_power_lambert_weight_fast(
    law: *const Lobe,
    at: Pair<f32>,
) -> f32 {
    unsafe { with(law, NONE, |law| Law::lambert_weight(&law, pair(at)).0) }
}
