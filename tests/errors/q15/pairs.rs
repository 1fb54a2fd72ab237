//! Pairs of words.

use coslobe::CosSin;
use fixed::types::I1F15;
use kit::integer::short::Pair;
use kit::integer::short::Q15;

pub(crate) fn length_off(at: Pair) -> f64 {
    (f64::from(at.cos.to_bits()).hypot(f64::from(at.sin.to_bits())) - Q15).abs()
}

/// The two words of an input.
pub(crate) fn pair(x: u32) -> Pair {
    CosSin {
        cos: I1F15::from_bits((x >> 16) as i16),
        sin: I1F15::from_bits(x as i16),
    }
}

/// All pairs in the closed support whose length is 1 to a unit.
pub(crate) fn unit_pairs(planar: bool) -> Vec<u32> {
    let mut pairs = Vec::new();
    for cos in 0..=i16::MAX {
        let sine = (Q15 * Q15 - f64::from(cos).powi(2)).sqrt();
        // Beside the axis many sines are as good, elsewhere one or two.
        let least = ((Q15 - 1.0).powi(2) - f64::from(cos).powi(2))
            .max(0.0)
            .sqrt();
        for sin in (least as i16 - 1).max(0)..=(sine.ceil() + 2.0).min(Q15 - 1.0) as i16 {
            for sin in if planar { vec![sin, -sin] } else { vec![sin] } {
                let x = (u32::from(cos as u16) << 16) | u32::from(sin as u16);
                if length_off(pair(x)) <= 1.0 {
                    pairs.push(x);
                }
            }
        }
    }
    pairs
}
