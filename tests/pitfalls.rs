//! What users of other samplers have hit, each as a test.
#![allow(clippy::incompatible_msrv)] // the MSRV is the core's; tests run on newer toolchains

use coslobe::{
    Ball, CircleArc, CircleShell, CosSin, Disk, Fast, Frame, Lambert, Law, Precise, Radius,
    Spatial, SpatialPoint, SphereShell, Tails, balance_heuristic, power_heuristic,
};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::SeedableRng;

/// pbrt-v4 #313: cos θ = 0 returned with density 0, then 0/0. Here the weight has a closed form.
#[test]
fn weights_never_divide_zero_by_zero() {
    let horizon = CosSin {
        cos: 0.0f32,
        sin: 1.0,
    };
    assert_eq!(Lambert.lambert_weight(horizon), 1.0);
    assert_eq!(CircleShell.lambert_weight(horizon), 1.0);
    assert_eq!(CircleArc.lambert_weight(horizon), 0.0);
    assert_eq!(Ball.lambert_weight(horizon), f32::INFINITY);
    assert_eq!(SphereShell.lambert_weight(horizon), f32::INFINITY);
    assert_eq!(Disk.lambert_weight(horizon), f32::INFINITY);
    let deepest = Ball.warp_tails(Tails::from_upper(0.5f32.powi(65)));
    assert!(Ball.density(deepest) > 0.0 && Ball.lambert_weight(deepest).is_finite());
    let horizon = CosSin {
        cos: Fast(0.0f32),
        sin: Fast(1.0),
    };
    assert_eq!(Lambert.lambert_weight(horizon).0, 1.0);
    assert_eq!(Ball.lambert_weight(horizon).0, f32::INFINITY);
    assert_eq!(Disk.lambert_weight(horizon).0, f32::INFINITY);
    let deepest = Ball.warp_tails(Tails::from_upper(Fast(0.5f32.powi(32))));
    assert!(Ball.density(deepest).0 > 0.0 && Ball.lambert_weight(deepest).0.is_finite());
}

/// pbrt-v3 #212: sin θ = √(1 − cos²θ) collapses below 1.5°.
#[test]
fn the_sine_keeps_its_digits_near_the_axis() {
    for exponent in 1..100 {
        let u = 0.5f64.powi(exponent);
        let sin = Lambert.warp(u as f32).sin;
        assert!(
            (f64::from(sin) / u.sqrt() - 1.0).abs() < 1e-7,
            "u = 2^-{exponent}"
        );
        let sin = Lambert.warp(Fast(u as f32)).sin.0;
        assert!(
            (f64::from(sin) / u.sqrt() - 1.0).abs() < 1.0 / 4096.0,
            "u = 2^-{exponent}"
        );
    }
}

/// ray-tracing-in-one-weekend #619, #1606; bevy #24203: normal + unit vector = 0 when they oppose.
#[test]
fn no_sample_around_a_normal_is_zero_or_biased() {
    let mut rng = Pcg32::seed_from_u64(3);
    let normal = [0.6f32, 0.0, -0.8];
    for _ in 0..100_000 {
        let d = Lambert.sample_around(normal, &mut rng);
        let length = d.iter().map(|c| c * c).sum::<f32>().sqrt();
        assert!((length - 1.0).abs() < 1e-6);
        let d = Lambert.sample_around(normal.map(Fast), &mut rng);
        let length = d.iter().map(|c| c.0 * c.0).sum::<f32>().sqrt();
        assert!((length - 1.0).abs() < 1.0 / 4096.0);
    }
}

/// mitsuba2 #309: 0/0 at the disk's centre in the concentric map.
#[test]
fn the_middle_of_the_square_is_an_ordinary_point() {
    let d = Lambert.warp_direction([0.5f32, 0.5]);
    assert!(d.iter().all(|c| c.is_finite()));
    assert_eq!(Disk.warp(0.5f64).sin, 0.0);
    assert!(Disk.warp(0.5f64).sin.is_sign_positive());
    let d = Lambert.warp_direction([Fast(0.5f32); 2]);
    assert!(d.iter().all(|c| c.0.is_finite()));
    let sin = Disk.warp(Fast(0.5f32)).sin.0;
    assert!(sin == 0.0 && sin.is_sign_positive());
}

/// Distributions.jl #2080, #2081: a root finder that fails on the disk's quantile.
#[test]
fn the_disk_quantile_never_fails() {
    for bits in (0..1.0f64.to_bits()).step_by(1 << 44) {
        let p = f64::from_bits(bits);
        let theta = Disk.quantile(p);
        assert!(theta.abs() <= std::f64::consts::FRAC_PI_2, "{p:e}");
        let next = f64::from_bits(bits + (1 << 44)).min(1.0);
        assert!(Disk.quantile(next) >= theta, "{p:e}");
        let precise = Disk.quantile(Precise(p));
        assert!((precise.0 - theta).abs() <= 4.0 * f64::EPSILON, "{p:e}");
        assert!(Disk.quantile(Precise(next)) >= precise, "{p:e}");
        let fast = Disk.quantile(Fast(p as f32)).0;
        assert!(
            (f64::from(fast) - Disk.quantile(f64::from(p as f32))).abs() < 1.6 / 4096.0,
            "{p:e}"
        );
    }
}

/// openqmc #84: a word that rounds up to 1.0 and leaves the interval.
#[test]
fn the_largest_word_stays_inside() {
    let [sin, cos] = {
        let at = Disk.warp_tails(coslobe::uniform::tails_from_bits::<f32>(u64::MAX));
        [at.sin, at.cos]
    };
    assert_eq!([sin, cos], [0.0, 1.0]);
    for word in [u64::MAX, u64::MAX >> 1] {
        let p = coslobe::uniform::tails_from_bits::<Fast<f32>>(word);
        assert_eq!([p.lower().0, p.upper().0], [0.5; 2]);
    }
}

/// The float nearest π/2 lies beyond π/2 in f32, inside in f64.
#[test]
fn the_support_ends_at_the_true_pi_over_two() {
    use std::f32::consts::FRAC_PI_2;
    assert_eq!(Ball.pdf_solid_angle(FRAC_PI_2), 0.0);
    assert!(Ball.pdf_solid_angle(FRAC_PI_2.next_down()) > 0.0);
    assert_eq!(Disk.ln_pdf(FRAC_PI_2), f32::NEG_INFINITY);
    assert!(Disk.pdf(std::f64::consts::FRAC_PI_2) > 0.0);
    assert_eq!(Disk.pdf(Precise(FRAC_PI_2)).0, 0.0);
    assert!(Disk.pdf(Precise(FRAC_PI_2.next_down())).0 > 0.0);
    assert!(Disk.pdf(Precise(std::f64::consts::FRAC_PI_2)).0 > 0.0);
    assert_eq!(Disk.pdf(Fast(FRAC_PI_2)).0, 0.0);
    assert!(Disk.pdf(Fast(FRAC_PI_2.next_down())).0 > 0.0);
    assert!(Disk.pdf(Disk.quantile(Fast(0.0f32))).0 > 0.0);
    assert!(Disk.pdf(Disk.quantile(Fast(1.0f32))).0 > 0.0);
    assert!(
        Disk.pdf(Disk.quantile(0.0f32)) > 0.0,
        "a quantile is always inside"
    );
    assert!(Disk.pdf(Disk.quantile(1.0f32)) > 0.0);
}

/// Lambert's reflector sampled by `Ball`: finite weights, infinite variance, tamed by MIS.
#[test]
fn the_infinite_variance_of_ball_is_there_and_balance_tames_it() {
    // E[w²] truncated at cos θ > ε grows without bound like −ln ε; MIS weights stay below 2.
    let second_moment = |epsilon: f64| {
        let n = 400_000;
        let step = -epsilon.ln() / f64::from(n);
        (0..n)
            .map(|i| {
                let cos = (-(f64::from(i) + 0.5) * step).exp();
                let at = CosSin {
                    cos,
                    sin: (1.0 - cos * cos).sqrt(),
                };
                let w: f64 = Ball.lambert_weight(at);
                w * w * Ball.density(at) * std::f64::consts::TAU * cos * step
            })
            .sum::<f64>()
    };
    let (near, far) = (second_moment(1e-3), second_moment(1e-6));
    assert!((far - near - 1e3f64.ln()).abs() < 1e-3, "{near} {far}");
    for cos in [1e-12f64, 1e-3, 0.5, 1.0] {
        let at = CosSin {
            cos,
            sin: (1.0 - cos * cos).sqrt(),
        };
        let (a, b) = (Ball.density(at), Lambert.density(at));
        assert!(Ball.lambert_weight(at) * balance_heuristic(a, b) <= 1.0 + 1e-12);
    }
}

#[test]
fn heuristics_survive_zero_and_infinity() {
    let inf = f64::INFINITY;
    for heuristic in [balance_heuristic::<f64>, power_heuristic::<f64>] {
        assert_eq!(heuristic(inf, 1.0), 1.0);
        assert_eq!(heuristic(1.0, inf), 0.0);
        assert_eq!(heuristic(inf, inf), 0.5);
        assert_eq!(heuristic(0.0, 0.0), 0.0);
        assert_eq!(heuristic(f64::MAX, f64::MAX), 0.5);
        assert!(heuristic(-1.0, 1.0).is_nan() && heuristic(1.0, f64::NAN).is_nan());
    }
    assert!((power_heuristic(3.0f64, 1.0) - 0.9).abs() < 3e-16);
    assert!(power_heuristic(1e200f64, 1e199) < 1.0);
}

#[test]
fn frames_are_exact_at_the_axes() {
    for (axis, sign) in [
        (0, 1.0f32),
        (0, -1.0),
        (1, 1.0),
        (1, -1.0),
        (2, 1.0),
        (2, -1.0),
    ] {
        let mut normal = [0.0f32; 3];
        normal[axis] = sign;
        let axes = Frame::from_unit(normal).axes();
        assert_eq!(axes[1], normal);
        for (i, a) in axes.iter().enumerate() {
            assert!(a.iter().all(|c| [0.0, 1.0, -1.0].contains(c)), "{axes:?}");
            for (j, b) in axes.iter().enumerate() {
                let dot: f32 = a.iter().zip(b).map(|(x, y)| x * y).sum();
                assert_eq!(dot, if i == j { 1.0 } else { 0.0 }, "{axes:?}");
            }
        }
        // Right-handed: x × y = z.
        let [x, y, z] = axes;
        let cross = [
            x[1] * y[2] - x[2] * y[1],
            x[2] * y[0] - x[0] * y[2],
            x[0] * y[1] - x[1] * y[0],
        ];
        assert_eq!(cross, z);
    }
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0f64]];
    assert_eq!(Frame::from_unit([0.0, 1.0, 0.0f64]).axes(), identity);
}

/// A direction found again from its own coordinates, for stratified and low-discrepancy points.
#[test]
fn directions_unwarp_to_the_square() {
    for i in 0..40 {
        for j in 0..40 {
            let u = [(f64::from(i) + 0.5) / 40.0, (f64::from(j) + 0.5) / 40.0];
            let back = SphereShell.unwarp_direction(SphereShell.warp_direction(u));
            assert!(
                (back[0] - u[0]).abs() < 1e-15 && (back[1] - u[1]).abs() < 1e-15,
                "{u:?} {back:?}"
            );
        }
    }
}

#[test]
fn points_keep_to_the_ball_at_both_ends_of_the_radius() {
    let mut rng = Pcg32::seed_from_u64(5);
    for rho in [f32::MIN_POSITIVE, f32::MAX / 4.0] {
        let rho = Radius::new(rho).expect("a valid radius");
        for _ in 0..1000 {
            let p = Ball.sample_point(rho, &mut rng);
            assert!(
                p.iter()
                    .all(|c| c.is_finite() && c.abs() <= 2.0 * rho.get()),
                "{p:?}"
            );
        }
    }
    assert!(Radius::new(f32::MIN_POSITIVE / 2.0).is_err());
    assert!(Radius::new(f32::MAX).is_err() && Radius::new(f32::NAN).is_err());
    let message = Radius::new(-1.0f64).expect_err("negative").to_string();
    assert!(message.contains("smallest positive normal"), "{message}");
}
