//! Real exponents against `f64`.

use super::{Worst, off, pair_off, tails, turn_off, worst};
use coslobe::{CosSin, Fixed};
use fixed::types::{I0F32, I1F31, U0F32, U16F16};
use kit::integer::reference::{Q31, Q32, power_pair};
use std::f64::consts::TAU;

/// (k, largest error of [warp, warp_sf, unit, quantile, cdf, sf, pdf, density]); the last two in
/// units of 2⁻¹⁶.
///
/// cdf and density grow with k: an angle or a pair rounded to its format is off by that much.
const POWERS: [(f64, [f64; 8]); 10] = [
    (0.0, [2.5, 2.5, 2.0, 2.0, 5.0, 5.0, 1.0, 0.5]),
    (1.0 / 65536.0, [2.5, 2.5, 2.0, 2.0, 5.0, 5.0, 1.01, 1.01]),
    (0.5, [2.5, 2.5, 2.0, 2.0, 5.0, 5.0, 1.01, 1.01]),
    (1.0, [2.5, 2.5, 2.0, 2.0, 6.0, 6.0, 1.01, 1.01]),
    (2.0, [2.5, 2.5, 2.0, 2.0, 6.0, 6.0, 1.01, 1.01]),
    (3.0, [2.5, 2.5, 2.0, 2.0, 6.0, 6.0, 1.01, 1.01]),
    (7.25, [2.5, 2.5, 2.0, 2.0, 6.0, 6.0, 1.01, 1.01]),
    (64.0, [2.5, 2.5, 2.0, 2.0, 8.0, 8.0, 1.01, 1.01]),
    (1000.0, [2.5, 2.5, 2.0, 2.0, 24.0, 24.0, 1.1, 1.1]),
    (
        65536.0 - 1.0 / 65536.0,
        [2.5, 2.5, 2.0, 2.0, 180.0, 180.0, 1.5, 30.0],
    ),
];

/// ln cos of an angle in turns, from the sine where the cosine has lost it.
fn ln_cos(turn: f64) -> f64 {
    let (sin, cos) = (turn * TAU).sin_cos();
    if sin < 0.7 {
        0.5 * (-sin * sin).ln_1p()
    } else {
        cos.ln()
    }
}

#[test]
fn cos_power_in_strides() {
    for (k, bounds) in POWERS {
        let law = Fixed(coslobe::integers::CosPower::new(U16F16::from_num(k)));
        let n = k + 1.0;
        let pair = |lower, upper| power_pair(k, lower, upper);
        // θ of the first quadrant.
        let theta = |x: u32| (I0F32::from_bits((x >> 2) as i32), f64::from(x >> 2) / Q32);
        let off_wide = |got: U16F16, want: f64| (f64::from(got.to_bits()) - want * 65536.0).abs();
        let rows: [(&str, &(dyn Fn(u32) -> f64 + Sync)); 8] = [
            ("warp", &|u| {
                let (lower, upper) = tails(u);
                pair_off(law.warp(U0F32::from_bits(u)), pair(lower, upper))
            }),
            ("warp_sf", &|q| {
                let (upper, lower) = tails(q);
                pair_off(law.warp_sf(U0F32::from_bits(q)), pair(lower, upper))
            }),
            ("unit", &|u| {
                let at = law.warp(U0F32::from_bits(u));
                (f64::from(at.cos.to_bits()).hypot(f64::from(at.sin.to_bits())) - Q31).abs()
            }),
            ("quantile", &|u| {
                let (lower, upper) = tails(u);
                let (cos, sin) = pair(lower, upper);
                turn_off(law.quantile(U0F32::from_bits(u)), sin.atan2(cos) / TAU)
            }),
            ("cdf", &|x| {
                let (bits, turn) = theta(x);
                off(law.cdf(bits), -(n * ln_cos(turn)).exp_m1())
            }),
            ("sf", &|x| {
                let (bits, turn) = theta(x);
                off(law.sf(bits), (n * ln_cos(turn)).exp())
            }),
            ("pdf", &|x| {
                let (bits, turn) = theta(x);
                let lobe = n / TAU * (k * ln_cos(turn)).exp();
                off_wide(law.pdf(bits), lobe * (turn * TAU).sin())
            }),
            ("density", &|x| {
                let (_, turn) = theta(x);
                let (sin, cos) = (turn * TAU).sin_cos();
                let of = |x: f64| I1F31::from_bits((x * Q31).round().min(Q31 - 1.0) as i32);
                let at = CosSin {
                    cos: of(cos),
                    sin: of(sin),
                };
                off_wide(law.density(at), n / TAU * (k * ln_cos(turn)).exp())
            }),
        ];
        for ((operation, error), bound) in rows.into_iter().zip(bounds) {
            let Worst(error, at) = worst(40009, error);
            println!("CosPower({k}) {operation}: {error:.3} at {at:#010x} (bound {bound})");
            assert!(
                error <= bound,
                "CosPower({k}) {operation}: {error} at {at:#010x}"
            );
        }
    }
}

/// Within 64 units of the horizon a unit is much of a cosine: small exponents feel it.
#[test]
fn pdf_of_small_exponents_beside_the_horizon() {
    let mut worst = [0.0f64; 2];
    for bits in (1..1 << 16).step_by(3) {
        let k = f64::from(bits) / 65536.0;
        let law = Fixed(coslobe::integers::CosPower::new(U16F16::from_bits(bits)));
        for units in (1..64).step_by(2).chain([64, 1 << 10, 1 << 20]) {
            let (cos, sin) = (f64::from(units) / Q32 * TAU).sin_cos();
            let want = (k + 1.0) / TAU * cos.powf(k) * sin;
            let got = law.pdf(I0F32::from_bits((1 << 30) - units));
            let beside = &mut worst[usize::from(units >= 64)];
            *beside = beside.max((f64::from(got) - want).abs() * 65536.0);
        }
    }
    println!("beside the horizon {}, elsewhere {}", worst[0], worst[1]);
    assert!(worst[0] <= 10.7 && worst[1] <= 1.1, "{worst:?}");
}

/// k = 0 is uniform on the hemisphere, its rim included; every other law is 0 there.
#[test]
fn the_rim_has_a_density_for_k_0_alone() {
    let uniform = (65536.0 / TAU).floor() as u32;
    let rim = CosSin {
        cos: I1F31::ZERO,
        sin: I1F31::MAX,
    };
    let quarter = I0F32::from_bits(1 << 30);
    for k in [0, 1, 1 << 16, u32::MAX] {
        let law = Fixed(coslobe::integers::CosPower::new(U16F16::from_bits(k)));
        let want = if k == 0 { uniform } else { 0 };
        assert_eq!(law.density(rim).to_bits(), want, "k = {k}/65536");
        assert_eq!(law.pdf(quarter).to_bits(), want, "k = {k}/65536");
        let past = I0F32::from_bits((1 << 30) + 1);
        assert_eq!(law.pdf(past), 0, "k = {k}/65536");
    }
}

/// Two equal components name two directions unless both are √½: that of cos θ counts, as in floats.
#[test]
fn equal_components_are_judged_by_the_cosine() {
    let law = Fixed(coslobe::integers::CosPower::new(U16F16::from_num(7)));
    for cos in [0.3, 0.6, 0.9] {
        let [cos, sin] = [I1F31::from_num(cos); 2];
        let want = 8.0 / TAU * f64::from(cos).powi(7);
        let got = f64::from(law.density(CosSin { cos, sin }));
        assert!((got - want).abs() < 2.0 / 65536.0, "{cos}: {got} {want}");
    }
}
