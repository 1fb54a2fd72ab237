//! The kernels of `Scaled` against those of plain double-double, where both reach: above all
//! around the exponents from which the leading term is taken.

extern crate std;

use super::*;
use crate::arithmetic::kernel::Kernel;
use crate::arithmetic::logarithmic::Logarithmic;
use crate::{CosSin, Tails};
use std::{vec, vec::Vec};

/// Every kernel at x < ½, in an arithmetic.
fn kernels<W: Logarithmic + Kernel<TailRoot = W>>(
    x: W,
    at_quadrant: fn(u32, W) -> CosSin<W>,
) -> Vec<W> {
    let pair = |at: CosSin<W>| [at.cos, at.sin];
    let steep = CosSin {
        cos: x,
        sin: W::ONE,
    };
    let flat = CosSin {
        cos: W::ONE,
        sin: x,
    };
    let seven = W::int(7);
    let mut out = vec![
        x + W::ONE,
        W::ONE - x,
        x * x,
        W::ONE / x,
        x.sqrt(),
        Kernel::cbrt(x),
        W::sqrt_scaled(x, |x| x / seven),
        Kernel::ln(x),
        Kernel::ln(W::ONE / x),
        W::ln_cos(steep),
        W::ln_cos(flat),
        W::ln_cos_power(seven, flat),
        x.atan2(W::ONE),
        W::ONE.atan2(x),
        (-x).atan2(-W::ONE),
        W::ONE.atan2(-x),
        W::from_end(x),
        W::disk_tail_at_angle(x),
        W::disk_tail_at_direction(x, W::ONE),
        W::disk_tail_at_direction(W::ONE, x),
        W::disk_angle_at_tail(x),
        W::exp_times(-x, seven),
        W::exp_times(seven, x),
        W::one_minus_exp(-x),
    ];
    for at in [
        W::at_angle(x),
        at_quadrant(3, x * W::QUARTER),
        W::at_turn(x),
        W::half_turn(x),
        W::disk_direction_at_tail(x),
        W::power_warp(Tails::from_nearer(x, true), seven),
        W::power_warp(Tails::from_nearer(x, false), seven),
    ] {
        out.extend(pair(at));
    }
    out
}

#[test]
fn agrees_with_double_double() {
    for e in 1..=200 {
        for part in [1.0, 1.37, 1.999] {
            let x = part * power_of_two(-1 - e);
            let scaled = kernels(Scaled::new(Double::from_f64(x), 0), Scaled::at_quadrant);
            for (i, (s, d)) in scaled
                .into_iter()
                .zip(kernels(Double::from_f64(x), Double::at_quadrant))
                .enumerate()
            {
                let d = Scaled::from_double(d);
                let rest = (s - d) / d;
                let near = s == d || rest.abs() < Scaled::new(Double::from_f64(1.0), -90);
                assert!(near, "kernel {i} at {x:e}: {s:?} and {d:?}");
            }
        }
    }
}

#[test]
fn the_ends_are_total() {
    let (zero, one, infinity) = (Scaled::ZERO, Scaled::ONE, Scaled::INFINITY);
    assert_eq!(one / zero, infinity);
    assert_eq!(one / infinity, zero);
    assert!((zero / zero).is_nan() && (infinity - infinity).is_nan());
    assert!((zero * infinity).is_nan() && Scaled::NAN.partial_cmp(&one).is_none());
    assert!(-infinity < -Scaled::MAX && Scaled::MAX < infinity);
    assert!(zero < Scaled::MIN_NORMAL && Scaled::MIN_NORMAL < one);
    // Far beyond what a formula reaches, in either direction.
    let mut square = Scaled::MAX;
    for _ in 0..30 {
        square = square * square;
    }
    assert_eq!(square, infinity);
    assert_eq!(one / square, zero);
}

/// Leading parts that cancel leave the trailing ones.
#[test]
fn a_difference_of_trailing_words_is_not_lost() {
    let small = power_of_two(-70);
    let x = Double { hi: 1.0, lo: small };
    assert_eq!(x - Double::ONE, Double::from_f64(small));
    let rest = Scaled::from_double(x) - Scaled::ONE;
    assert_eq!(rest, Scaled::from_double(Double::from_f64(small)));
    assert!(Scaled::ONE < Scaled::from_double(x));
}
