//! The references of the sweeps against each other: what the narrower claims, the wider confirms.

use kit::accuracy::double::Double;
use kit::accuracy::format::{Format, nearest};
use kit::accuracy::inputs::{exponents, stratified};
use kit::accuracy::long::Long;
use kit::accuracy::measure::Input;
use kit::accuracy::reference::Id;
use kit::accuracy::truths::{runs_out, values};
use kit::accuracy::wide::Wide;
use rayon::prelude::*;

/// Worst difference over `Narrow::EPS` of all values of the laws at n stratified inputs; values
/// that `Narrow` has no exponents for are left out.
fn agrees<F: Format, W: Wide, V: Wide>(laws: &[Id], n: u64) {
    let n = n - n % 3;
    for &law in laws {
        for input in Input::ALL {
            (0..n).into_par_iter().for_each(|i| {
                let x = stratified::<F>(input.top::<F>(), i, n);
                if runs_out(law, x) {
                    return;
                }
                let narrow = values::<F, W>(law, input, x);
                let wide = values::<F, V>(law, input, x);
                for (k, (a, b)) in narrow.into_iter().zip(wide).enumerate() {
                    let (want, got) = (b.near(), a.near());
                    let held = F::FLOOR.max(1e-300)..1e290;
                    if want == got && !want.is_normal() || !held.contains(&want.abs()) {
                        continue;
                    }
                    // The logarithm's terms may cancel.
                    let terms = if k == 1 && matches!(law, Id::CosPower(_)) {
                        700.0
                    } else {
                        0.0
                    };
                    let apart = (b - V::parts(a.lifted(0).hi, a.lifted(0).lo)).near().abs();
                    let share = apart / (want.abs() + terms) / W::EPS;
                    assert!(
                        share <= 1.0,
                        "{law:?} {input:?} value {k} at {:#x}: {got:e}, {want:e}, {share}",
                        x.bits()
                    );
                }
            });
        }
    }
}

#[test]
fn f64_keeps_its_bound_for_f32() {
    agrees::<f32, f64, Double>(&Id::FIXED, 150_000);
    agrees::<f32, f64, Double>(&exponents::<f32>(), 30_000);
}

/// Different where exponents run out, and in the order of their operations nowhere.
#[test]
fn the_long_range_agrees_with_double_double() {
    agrees::<f64, Double, Long>(&Id::FIXED, 30_000);
    agrees::<f64, Double, Long>(&exponents::<f64>(), 3_000);
    agrees::<f32, Double, Long>(&Id::FIXED, 30_000);
}

/// Rounding to the nearest number, by exact cases on both sides of ties, to subnormals too.
#[test]
fn nearest_numbers() {
    let tie = f64::from(1.5f32) + 2f64.powi(-24);
    let odd = f64::from(f32::from_bits(1.5f32.to_bits() + 1));
    let case = |hi: f64, lo: f64| nearest::<f32>(Double::sum(hi, lo), 0);
    assert_eq!(case(tie, 0.0), 1.5);
    assert_eq!(case(tie, 1e-30), odd as f32);
    assert_eq!(case(tie, -1e-30), 1.5);
    assert_eq!(
        case(odd + 2f64.powi(-24), 0.0),
        f32::from_bits(1.5f32.to_bits() + 2)
    );
    let least = f64::from(f32::from_bits(1));
    assert_eq!(case(least * 0.5, 0.0), 0.0);
    assert_eq!(case(least * 0.5, 1e-80), f32::from_bits(1));
    assert_eq!(case(least * 2.5, 0.0), f32::from_bits(2));
    assert_eq!(case(f64::from(f32::MAX), 2f64.powi(103)), f32::INFINITY);
    assert_eq!(case(-tie, -1e-30), -odd as f32);
    let ulp = f64::EPSILON;
    assert_eq!(nearest::<f64>(Double::sum(1.0, ulp / 2.0), 0), 1.0);
    let above = Double {
        hi: 1.0 + ulp,
        lo: ulp / 2.0,
    };
    assert_eq!(nearest::<f64>(above, 0), 1.0 + 2.0 * ulp);
    // 2.5 of the least number, times 2⁵⁰⁰.
    let lifted = Double::from(2.5 * 2f64.powi(-1074 + 500));
    assert_eq!(nearest::<f64>(lifted, 500).to_bits(), 2);
    let lifted = Double::sum(2.5 * 2f64.powi(-574), 1e-200);
    assert_eq!(nearest::<f64>(lifted, 500).to_bits(), 3);
}
