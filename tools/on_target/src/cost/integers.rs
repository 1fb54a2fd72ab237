//! Absolute errors of directions in integers: their unit does not shrink with the component.

use coslobe::integers::CosPower;
use coslobe::{CosSin, Fixed};
use fixed::types::{I1F31, U0F32, U16F16};
use kit::formulas::{EXPONENT, lambert_by_idsp};
use kit::integer::reference::{Q31, Q32, power_pair, subjects};
use kit::integer::short;

/// Words in each octave from either end.
const PER_OCTAVE: u32 = 256;

/// The largest error of a component of (cos θ, sin θ).
pub(crate) fn error(binary: &str, law: &str, operation: &str) -> Option<f64> {
    if !["sample", "warp", "warp_sf"].contains(&operation) {
        return None;
    }
    match binary {
        "fixed" => ours(law),
        "fixed16" => short(law),
        "idsp" => Some(idsp()),
        _ => None,
    }
}

/// Words that crowd at 0, and their complements.
fn words() -> impl Iterator<Item = u32> {
    let octaves = (0..32).flat_map(|octave| {
        let step = ((1u64 << octave) / u64::from(PER_OCTAVE)).max(1);
        let end = 2u64 << octave;
        ((1u64 << octave)..end).step_by(step as usize)
    });
    let near = octaves.map(|w| w as u32);
    near.clone().chain(near.map(|w| !w))
}

fn ours(law: &str) -> Option<f64> {
    if law == "CosPower(20)" {
        let lobe = Fixed(CosPower::new(U16F16::from_num(EXPONENT)));
        return Some(worst(
            |w| lobe.warp(U0F32::from_bits(w)),
            |w| lobe.warp_sf(U0F32::from_bits(w)),
            |lower, upper| power_pair(EXPONENT.into(), lower, upper),
        ));
    }
    let law = subjects().into_iter().find(|s| s.name == law)?;
    Some(worst(law.warp, law.warp_sf, |lower, upper| {
        law.pair(lower, upper)
    }))
}

/// In 16 bits, on every word.
fn short(law: &str) -> Option<f64> {
    let law = short::subjects().into_iter().find(|s| s.name == law)?;
    let each = (0..=u16::MAX).map(|w| {
        let (p, rest) = (f64::from(w) / 65536.0, (65536.0 - f64::from(w)) / 65536.0);
        let near = off((law.warp)(w), law.pair(p, rest));
        near.max(off((law.warp_sf)(w), law.pair(rest, p)))
    });
    Some(each.fold(0.0, f64::max))
}

fn off<T: Into<f64>>(got: CosSin<T>, (cos, sin): (f64, f64)) -> f64 {
    (got.cos.into() - cos)
        .abs()
        .max((got.sin.into() - sin).abs())
}

/// Of both entries, of which a sample's error is that of the law's nearer one.
fn worst(
    warp: impl Fn(u32) -> CosSin<I1F31>,
    warp_sf: impl Fn(u32) -> CosSin<I1F31>,
    pair: impl Fn(f64, f64) -> (f64, f64),
) -> f64 {
    let each = words().map(|w| {
        let (p, rest) = (f64::from(w) / Q32, (Q32 - f64::from(w)) / Q32);
        off(warp(w), pair(p, rest)).max(off(warp_sf(w), pair(rest, p)))
    });
    each.fold(0.0, f64::max)
}

/// At a fixed azimuth of 0.3 turns; a word w is the uniform (w + ½)·2⁻³².
fn idsp() -> f64 {
    let phase = 0x4CCC_CCCDu32;
    let (s, c) = (f64::from(phase) / Q32 * std::f64::consts::TAU).sin_cos();
    let each = words().map(|w| {
        let u = (f64::from(w) + 0.5) / Q32;
        let want = [(1.0 - u).sqrt() * c, u.sqrt(), (1.0 - u).sqrt() * s];
        let got = lambert_by_idsp(w, phase).map(|x| f64::from(x) / Q31);
        let off = want.iter().zip(got).map(|(want, got)| (want - got).abs());
        off.fold(0.0, f64::max)
    });
    each.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integers_err_by_units() {
        for law in ["Lambert", "CosPower(20)"] {
            let ours = error("fixed", law, "sample").unwrap();
            assert!(ours > 0.0 && ours <= 4.0 / Q31, "{law}: {ours:e}");
        }
        let short = error("fixed16", "Disk", "sample").unwrap();
        assert!((1.0..2.0).contains(&(short * 32768.0)), "{short:e}");
        let idsp = error("idsp", "Lambert", "sample").unwrap();
        assert!((1e-6..1e-4).contains(&idsp), "{idsp:e}");
        assert_eq!(error("f32", "Lambert", "sample"), None);
        assert_eq!(error("fixed", "Lambert", "pdf"), None);
    }
}
