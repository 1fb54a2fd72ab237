//! Inputs found by attack, each of which once exceeded its cell of `docs/bounds.md`.

use kit::accuracy::bounds::{allowed, broken};
use kit::accuracy::found;
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

/// What `accuracy_cost search` found, judged again.
#[test]
fn searched_inputs_are_within_their_cells() {
    let text = include_str!("../docs/measured/worst_inputs.json");
    let rows = found::from_json(text).expect("rows");
    for law in Id::FIXED {
        let searched = |tier: &str| rows.iter().any(|r| r.tier == tier && r.law == law.name());
        assert!(searched("f64") && searched("Precise<f64>"), "{law:?}");
    }
    for row in rows {
        let cell = allowed(&row.tier, &row.law, &row.operation).expect("a cell");
        let error = row.again().expect("an input that exists");
        assert!(error <= cell && row.error <= cell, "{row:?}: {error} today");
    }
}

/// The README's figure of `f64` is the search's.
#[test]
fn the_headline_is_what_the_search_found() {
    let text = include_str!("../docs/measured/worst_inputs.json");
    let rows = found::from_json(text).expect("rows");
    let fixed = rows
        .iter()
        .filter(|r| r.tier == "f64" && r.law != "CosPower");
    let worst = fixed
        .max_by(|a, b| a.error.total_cmp(&b.error))
        .expect("rows of f64");
    let headline = format!("{:.2} in `f64` (searched", worst.error);
    assert!(
        include_str!("../README.md").contains(&headline),
        "{headline}: {worst:?}"
    );
}
