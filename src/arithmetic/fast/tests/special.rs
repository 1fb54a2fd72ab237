//! Inputs that are not ordinary numbers.

use super::{END, MAX, TINY, TailRoot};
use crate::Tails;
use crate::arithmetic::fast::power::Exponent;
use crate::arithmetic::fast::{angle, kepler, power, root};

/// Nothing panics or leaves its range, whatever the input; NaN in, NaN out.
#[test]
fn total() {
    let ones: [fn(f32) -> f32; 13] = [
        root::cbrt,
        power::ln,
        super::exp,
        power::one_minus_exp,
        kepler::tail_at_angle,
        kepler::angle_at_tail,
        |x| angle::sin_cos(x).0,
        |x| angle::sin_cos(x).1,
        |x| angle::turn(x).0,
        |x| angle::turn(x).1,
        |x| angle::half_turn(x).1,
        |x| kepler::direction_at_tail(x).0,
        |x| kepler::direction_at_tail(x).1,
    ];
    let twos: [fn(f32, f32) -> f32; 4] = [
        angle::atan2_first,
        angle::atan2,
        power::ln_cos,
        kepler::tail_at_direction,
    ];
    for bits in (0..=u32::MAX).step_by(9973) {
        let x = f32::from_bits(bits);
        for f in ones {
            assert!(f(x).is_nan() || !x.is_nan());
        }
        for y in [0.0, -0.0, 1.0, f32::INFINITY, f32::NAN, 1e-40] {
            for f in twos {
                f(x, y);
                f(y, x);
            }
        }
    }
}

#[test]
fn special_values() {
    let inf = f32::INFINITY;
    let f = root::cbrt;
    assert_eq!((f(0.0), f(1.0)), (0.0, 1.0));
    assert!(f(-0.0).is_sign_negative() && f(f32::NAN).is_nan());
    // Subnormals lie in order between 0 and the least normal number.
    let (least, most) = (f(f32::from_bits(1)), f(f32::from_bits(0x007F_FFFF)));
    assert!(0.0 < least && least < most && most <= f(TINY) * 1.001);
    assert_eq!(
        (power::ln(0.0), power::ln(1.0), power::ln(inf)),
        (-inf, 0.0, inf)
    );
    assert!(power::ln(-1.0).is_nan() && power::ln(f32::from_bits(1)) < -87.0);
    assert_eq!(
        (super::exp(-inf), super::exp(inf), super::exp(89.0)),
        (0.0, inf, inf)
    );
    assert_eq!(
        (power::one_minus_exp(0.0), power::one_minus_exp(-inf)),
        (0.0, 1.0)
    );
    assert_eq!(power::ln_cos(1.0, 0.0), 0.0);
    let (pi, half) = (core::f32::consts::PI, core::f32::consts::FRAC_PI_2);
    assert_eq!((angle::atan2(0.0, 0.0), angle::atan2(0.0, -0.0)), (0.0, pi));
    assert_eq!(
        (angle::atan2(-0.0, -1.0), angle::atan2(1.0, -0.0)),
        (-pi, half)
    );
    assert_eq!(
        (angle::atan2_first(1.0, inf), angle::atan2_first(inf, 1.0)),
        (0.0, END)
    );
    assert!((angle::atan2_first(inf, inf) - half / 2.0).abs() < 1e-4);
    assert_eq!(kepler::direction_at_tail(0.0).0, 0.0);
    assert_eq!(kepler::direction_at_tail(0.5), (1.0, 0.0));
    assert_eq!(kepler::angle_at_tail(0.0), END);
    let quarters = [0.0, 0.25, 0.5, 0.75, 1.0].map(angle::turn);
    assert!(quarters.iter().all(|&(cos, sin)| cos * sin == 0.0));
    assert!(quarters[0].1 == 0.0 && quarters[1].0 == 0.0 && quarters[2].1 == 0.0);
    assert!(angle::sin_cos(END).0 > 0.0 && kepler::tail_at_angle(END) > 0.0);
}

/// Every fraction that the power and the root see, below 1.
#[test]
fn nothing_rounds_to_more_than_one() {
    for i in 0..1 << 15 {
        let power = Exponent::of(-f32::from(i as u16) / 32768.0).power();
        assert!(power <= 1.0 && (i != 0 || power == 1.0), "{i}: {power}");
        let x = f32::from_bits(0x3F7F_FFFF - (i << 8));
        assert!(root::cbrt(x) <= 1.0, "{x}");
        let p = x / 2.0;
        assert!(kepler::direction_at_tail(p).0 <= 1.0, "{p}");
        for u in [1.0 - x, x / 4.0, p, 0.5 + p, x] {
            let (cos, sin) = angle::turn(u);
            assert!(cos.abs() <= 1.0 && sin.abs() <= 1.0, "{u}");
        }
        let (cos, sin) = (angle::half_turn(p).0, angle::half_turn(x / 4.0).1);
        assert!(cos <= 1.0 && sin <= 1.0, "{p}");
    }
}

#[test]
fn roots_of_tails_at_the_ends() {
    let least = f32::from_bits(1);
    for n in [1.0, 21.0, 1e30, MAX] {
        let at = |p| TailRoot::new(n).at(p);
        assert_eq!(at(Tails::from_lower(0.0)), (1.0, 0.0), "{n}");
        assert_eq!(at(Tails::from_upper(0.0)), (0.0, 1.0), "{n}");
        let (cos, sin) = at(Tails::from_upper(f32::NAN));
        assert!(cos.is_nan() && sin.is_nan());
        assert!(at(Tails::from_lower(least)).1 > 0.0 || n == MAX, "{n}");
    }
    // The tail itself, where it is subnormal.
    for i in [1, 2, 77, 0x3F_FFFF, 0x7F_FFFF] {
        let p = f32::from_bits(i);
        let cos = TailRoot::new(1.0).at(Tails::from_upper(p)).0;
        assert!((cos - p).abs() <= (p * 1e-4).max(least), "{p:e}: {cos:e}");
    }
}
