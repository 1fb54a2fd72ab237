//! Points before normalisation: distances and densities against the formulas in wider arithmetic.

use coslobe::{
    Ball, CircleArc, CircleShell, CosSin, Disk, Fast, Lambert, Measure, Precise, Radius,
    SphereShell, Tangent,
};
use kit::Number;
use kit::accuracy::format::{Format, error_in_ulps, ulp};
use kit::accuracy::wide::Wide;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::{Rng, SeedableRng};

/// Allowed ulps of distances and densities: as the docs of `Tangent` state, or 2⁻¹².
fn allowed<T: Number>() -> f64 {
    if T::NAME.starts_with("Fast") {
        2f64.powi(T::Raw::DIGITS - 1 - 12)
    } else {
        4.0
    }
}

/// The density's coefficient, power of ρ, and the root of v in the distance.
fn shape<W: Wide>(measure: Measure) -> Option<(W, i32, i32)> {
    let (one, pi) = (W::of(1.0), W::pi());
    match measure {
        Measure::Area => Some((one / pi, 2, 2)),
        Measure::ArcLength => Some((one / (pi * W::of(2.0)), 1, 0)),
        Measure::Volume => Some((W::of(3.0) / (pi * W::of(4.0)), 3, 3)),
        Measure::SurfaceArea => Some((one / (pi * W::of(4.0)), 2, 0)),
        Measure::CircleShell | Measure::SphereShell => None,
    }
}

fn judge<T: Number, L: Tangent<T>>(law: &L, rho: T, u: T, v: T) {
    let wide = |x: T| x.wide();
    let exact = |x: T| <T::Raw as Format>::Wide::of(wide(x));
    let allowed = allowed::<T>();
    let radius = Radius::new(rho).expect("a valid radius");
    let at = law.warp_sf(u);
    let r = law.distance(radius, at, v);
    let (wide_rho, cos) = (exact(rho), exact(at.cos));
    let wide_v = exact(v);
    let place = format!("{:?} rho {rho:?} u {u:?} v {v:?}", L::MEASURE);
    let Some((coefficient, power, root)) = shape::<<T::Raw as Format>::Wide>(L::MEASURE) else {
        // The shells' coefficient of δ is the pdf in θ.
        let pdf = law.density(at)
            * if L::MEASURE == Measure::SphereShell {
                at.sin
            } else {
                T::of(1.0)
            };
        assert_eq!(
            law.point_density(radius, at, r).bits(),
            pdf.bits(),
            "{place}"
        );
        return;
    };
    let share = match root {
        2 => wide_v.root(),
        3 => wide_v.cube_root(),
        _ => <T::Raw as Format>::Wide::of(1.0),
    };
    // Halves first: ρ cos θ · share cannot overflow, and the last doubling is exact.
    let distance = wide_rho * (cos * share) * <T::Raw as Format>::Wide::of(2.0);
    assert!(
        error_in_ulps(r.raw(), distance) <= allowed,
        "{place}: distance {r:?}"
    );
    let mut density = coefficient;
    for _ in 0..power {
        density = density / wide_rho;
    }
    let got = law.point_density(radius, at, r);
    // A double-double that overflows is ∞ − ∞.
    let near = if density.near().is_nan() {
        f64::INFINITY
    } else {
        density.near()
    };
    if near.is_finite() && near > 0.0 {
        assert!(
            error_in_ulps(got.raw(), density) <= allowed,
            "{place}: density {got:?}"
        );
    } else {
        assert!(wide(got) == near, "{place}: density {got:?}");
    }
    let log = coefficient.ln() - wide_rho.ln() * <T::Raw as Format>::Wide::of(f64::from(power));
    let scale = wide_rho.ln().near().abs().max(1.0) * f64::from(power);
    let error = log.minus(wide(law.ln_point_density(radius, at, r))).abs();
    assert!(
        error <= allowed * ulp::<T::Raw>(scale),
        "{place}: ln density off by {error:e}"
    );
    if root > 0 {
        let beyond = T::of(distance.near() * 1.001 / share.near());
        assert_eq!(wide(law.point_density(radius, at, beyond)), 0.0, "{place}");
        assert_eq!(
            wide(law.ln_point_density(radius, at, beyond)),
            f64::NEG_INFINITY,
            "{place}"
        );
    }
}

/// Radii over the whole admitted range, the ends included.
fn everywhere<T: Number>() {
    let mut rng = Pcg64::seed_from_u64(17);
    let mut unit = move || (rng.next_u64() >> 12) as f64 / 2f64.powi(52) + 2f64.powi(-53);
    let round = |x| T::of(x);
    let least = 2f64.powi(T::Raw::LEAST);
    let (low, high) = (least.log2(), (T::Raw::MAX_VALUE / 4.0).log2());
    for i in 0..20_000 {
        let rho = match i {
            0 => least,
            1 => T::Raw::MAX_VALUE / 4.0,
            _ => 2f64
                .powf(low + (high - low) * unit())
                .clamp(least, T::Raw::MAX_VALUE / 4.0),
        };
        let (rho, u, v) = (round(rho), round(unit()), round(unit()));
        judge(&Disk, rho, u, v);
        judge(&CircleArc, rho, u, v);
        judge(&CircleShell, rho, u, v);
        judge(&Ball, rho, u, v);
        judge(&SphereShell, rho, u, v);
        judge(&Lambert, rho, u, v);
    }
}

#[test]
fn f32_points() {
    everywhere::<f32>();
}

#[test]
fn f64_points() {
    everywhere::<f64>();
}

#[test]
fn precise_points() {
    everywhere::<Precise<f32>>();
    everywhere::<Precise<f64>>();
}

#[test]
fn fast_points() {
    everywhere::<Fast<f32>>();
}

/// A direction outside the support has no points, and a shell's density keeps its sign.
#[test]
fn no_points_outside_the_support() {
    let rho = Radius::new(1.0f64).expect("a valid radius");
    for at in [
        CosSin {
            cos: -0.6,
            sin: 0.8,
        },
        CosSin {
            cos: 0.8,
            sin: -0.6,
        },
    ] {
        assert_eq!(Ball.point_density(rho, at, 0.1), 0.0);
        assert_eq!(Lambert.point_density(rho, at, 0.1), 0.0);
        assert_eq!(
            SphereShell.ln_point_density(rho, at, 0.1),
            f64::NEG_INFINITY
        );
    }
    let mirrored = CosSin {
        cos: 0.8,
        sin: -0.6,
    };
    assert!(Disk.point_density(rho, mirrored, 0.1) > 0.0);
    assert!(Disk.point_density(rho, mirrored, f64::NAN).is_nan());
}
