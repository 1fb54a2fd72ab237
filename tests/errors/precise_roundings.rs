//! `Precise<f32>` where what lies behind the digits of its quick phase decides.

use coslobe::{CosPower, CosSin, Law, Precise};

/// Where the density passes 1 the terms of its logarithm cancel, and `f64` has lost the digits that
/// its margin would count from.
#[test]
fn a_logarithm_that_cancels() {
    let [k, theta] = [0x567e_3b4f, 0x3534_abfa].map(f32::from_bits);
    let wide = CosPower::new(Precise(f64::from(k))).expect("an exponent");
    let value = wide.ln_pdf(Precise(f64::from(theta))).0;
    let law = CosPower::new(Precise(k)).expect("an exponent");
    assert_eq!(law.ln_pdf(Precise(theta)).0, value as f32);
}

/// 1 − (1 − v)² of v = 2⁻²⁴ lies exactly between two numbers, of which 2⁻²³ is the even one.
#[test]
fn an_exact_tie() {
    let law = CosPower::new(Precise(3.0f32)).expect("an exponent");
    let at = CosSin {
        cos: Precise(1.0),
        sin: Precise(0.5f32.powi(12)),
    };
    assert_eq!(law.unwarp(at).0, 0.5f32.powi(23));
}
