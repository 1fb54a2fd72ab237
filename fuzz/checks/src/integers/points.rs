//! Points with a radius, in both formats.

use super::format::wide;
use crate::input::Input;
use coslobe::integers::FixedRadius;
use coslobe::{CosSin, Fixed, Fixed16};
use fixed::types::{I1F15, I1F31, I16F0, I32F0, U0F16, U0F32};
use kit::catalogue::IntegerLaw;
use kit::integer::truth::Truth;

/// Units that a distance may be off.
const UNITS: f64 = 1.75;

pub(super) fn distances<L: IntegerLaw>(law: L, input: &mut Input) {
    let truth = Truth::of(L::ID);
    let (rho, at, v) = (input.words.word(), input.words.word(), input.words.word());
    let near = |got: f64, rho: f64, cos: f64, v: f64| {
        let want = truth.distance(rho, cos, v);
        let off = (got - want).abs();
        assert!(
            off <= UNITS,
            "distance {got} is not {want}: ρ {rho}, cos θ {cos}, v {v}"
        );
    };
    // At most a quarter of the largest number.
    let radius = FixedRadius::new(I32F0::from_bits((rho >> 35).max(1) as i32)).expect("a radius");
    let cos = I1F31::from_bits((at >> 33) as i32);
    let share = U0F32::from_bits((v >> 32) as u32);
    let pair = CosSin {
        cos,
        sin: I1F31::ZERO,
    };
    let got = Fixed(law).distance(radius, pair, share);
    near(wide(got), wide(radius.get()), wide(cos), wide(share));
    let drawn = Fixed(law).sample_distance(radius, pair, &mut input.words.clone());
    assert!(
        drawn >= 0 && drawn <= radius.get() * 2,
        "{drawn} of {radius:?}"
    );

    let radius = FixedRadius::new(I16F0::from_bits((rho >> 51).max(1) as i16)).expect("a radius");
    let cos = I1F15::from_bits((at >> 49) as i16);
    let share = U0F16::from_bits((v >> 48) as u16);
    let pair = CosSin {
        cos,
        sin: I1F15::ZERO,
    };
    let got = Fixed16(law).distance(radius, pair, share);
    near(wide(got), wide(radius.get()), wide(cos), wide(share));
    let drawn = Fixed16(law).sample_distance(radius, pair, &mut input.words.clone());
    assert!(
        drawn >= 0 && drawn <= radius.get() * 2,
        "{drawn} of {radius:?}"
    );
}
