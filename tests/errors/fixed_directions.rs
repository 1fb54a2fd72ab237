//! `warp_direction` and `unwarp_direction` in integers against `f64`.

use coslobe::rand_core::Rng;
use coslobe::{Ball, Fixed, Fixed16, Lambert};
use fixed::types::{U0F16, U0F32};
use kit::integer::{Format, Long, Short};
use kit::stats::words;

/// Largest error of a component of `warp_direction` and of `unwarp_direction` [θ, φ], in units.
fn warped(k: i32) -> [f64; 3] {
    let mut rng = words::pcg("warped");
    let mut worst = [0.0f64; 3];
    for _ in 0..400_000 {
        let u = [rng.next_u32(), rng.next_u32()].map(U0F32::from_bits);
        let [p, turn] = u.map(f64::from);
        let cos = (1.0 - p).powf(1.0 / f64::from(k + 1));
        let sin = (-(((-p).ln_1p() * 2.0) / f64::from(k + 1)).exp_m1()).sqrt();
        let (s, c) = (turn * std::f64::consts::TAU).sin_cos();
        let (d, back) = match k {
            1 => {
                let d = Fixed(Lambert).warp_direction(u);
                (d, Fixed(Lambert).unwarp_direction(d))
            }
            _ => {
                let d = Fixed(Ball).warp_direction(u);
                (d, Fixed(Ball).unwarp_direction(d))
            }
        };
        for (found, want) in d.into_iter().zip([sin * c, cos, sin * s]) {
            worst[0] = worst[0].max((f64::from(found) - want).abs() / Long::UNIT);
        }
        let q32 = 4294967296.0;
        worst[1] = worst[1].max((f64::from(back[0]) - p).abs() * q32);
        // A turn's digits are as many as sin θ has.
        let off = f64::from(back[1].to_bits().wrapping_sub(u[1].to_bits()) as i32).abs();
        worst[2] = worst[2].max(off * sin);
    }
    worst
}

#[test]
fn directions_warp_and_unwarp() {
    let found = [warped(1), warped(3)];
    println!("{found:?}");
    for errors in found {
        let bounds = [4.0, 24.0, 4.0];
        assert!(errors.iter().zip(bounds).all(|(e, b)| *e <= b), "{found:?}");
    }
    let mut worst = [0.0f64; 2];
    for i in 0..=u16::MAX {
        let u = [i, i.wrapping_mul(0x9E37)].map(U0F16::from_bits);
        let [p, turn] = u.map(f64::from);
        let (s, c) = (turn * std::f64::consts::TAU).sin_cos();
        let (cos, sin) = ((1.0 - p).sqrt(), p.sqrt());
        let d = Fixed16(Lambert).warp_direction(u);
        for (found, want) in d.into_iter().zip([sin * c, cos, sin * s]) {
            worst[0] = worst[0].max((f64::from(found) - want).abs() / Short::UNIT);
        }
        let [_, back] = Fixed16(Lambert).unwarp_direction(d);
        let off = f64::from(back.to_bits().wrapping_sub(u[1].to_bits()) as i16).abs();
        worst[1] = worst[1].max(off * sin);
    }
    println!("{worst:?}");
    assert!(worst[0] <= 2.0 && worst[1] <= 4.0, "{worst:?}");
}
