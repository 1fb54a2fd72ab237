//! Inputs found by attack, each of which once exceeded its cell of `docs/bounds.md`.

use kit::accuracy::bounds::broken;
use kit::accuracy::measure::{Input, judge};
use kit::accuracy::reference::Id;
use kit::accuracy::subject::{Subject, Tiers};

/// Law, what the input is, its bits.
type Found = (Id, Input, u64);

/// f32: `Ball.lambert_weight` where cos²θ is subnormal: 8.12 ulp.
const F32: [Found; 1] = [(Id::Ball, Input::Cos, 0x1f36_26eb)];

/// f64: `Ball.ln_pdf`, three times the error of a logarithm: 4.121 ulp; `Ball.lambert_weight` where
/// cos²θ is subnormal: 8.33 ulp.
const F64: [Found; 2] = [
    (Id::Ball, Input::Angle, 0x3fe9_5e0b_765a_2aff),
    (Id::Ball, Input::Cos, 0x1fe6_bad7_20c5_12e2),
];

/// The input and its neighbours, as inputs of all operations in all number types.
fn within_their_cells<F: Tiers>(found: &[Found]) {
    for &(id, input, bits) in found {
        let subjects = Subject::<F>::all(&[id]);
        let around: Vec<F> = (bits - 64..=bits + 64).map(F::of_bits).collect();
        let broken = broken(&subjects, &judge(&subjects, input, &around));
        assert!(broken.is_empty(), "{}", broken.join("\n"));
    }
}

#[test]
fn worst_inputs_of_f32() {
    within_their_cells::<f32>(&F32);
}

#[test]
fn worst_inputs_of_f64() {
    within_their_cells::<f64>(&F64);
}

/// Every law where a square or a cube of the cosine or sine is subnormal.
fn powers_beside_underflow<F: Tiers>() {
    let least = F::of(2f64.powi(F::LEAST)).wide();
    let subjects = Subject::<F>::all(&Id::FIXED);
    for root in [least.sqrt(), least.cbrt(), least.sqrt().sqrt(), least] {
        // By steps of a thousandth, from 2⁻⁴⁰ to 2⁴ times the end.
        let x: Vec<F> = (-30_000..3000)
            .map(|i| F::of(root * 2f64.powf(f64::from(i) / 750.0)))
            .collect();
        for input in [Input::Cos, Input::Sin] {
            let broken = broken(&subjects, &judge(&subjects, input, &x));
            assert!(broken.is_empty(), "{}", broken.join("\n"));
        }
    }
}

#[test]
fn subnormal_powers() {
    powers_beside_underflow::<f32>();
    powers_beside_underflow::<f64>();
}
