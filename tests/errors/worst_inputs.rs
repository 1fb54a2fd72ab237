//! Inputs found by attack, each of which once exceeded its cell of `docs/bounds.md`.

use kit::accuracy::bounds::{allowed, broken};
use kit::accuracy::found::{self, Found};
use kit::accuracy::measure::{Input, judge};
use kit::accuracy::op::OPERATIONS;
use kit::accuracy::reference::Id;
use kit::accuracy::subject::{Subject, Tiers};

/// Law, what the input is, its bits.
type Attack = (Id, Input, u64);

/// f32: `Ball.lambert_weight` where cos²θ is subnormal: 8.12 ulp.
const F32: [Attack; 1] = [(Id::Ball, Input::Cos, 0x1f36_26eb)];

/// f64: `Ball.ln_pdf`, three times the error of a logarithm: 4.121 ulp; `Ball.lambert_weight` where
/// cos²θ is subnormal: 8.33 ulp.
const F64: [Attack; 2] = [
    (Id::Ball, Input::Angle, 0x3fe9_5e0b_765a_2aff),
    (Id::Ball, Input::Cos, 0x1fe6_bad7_20c5_12e2),
];

/// The input and its neighbours, as inputs of all operations in all number types.
fn within_their_cells<F: Tiers>(found: &[Attack]) {
    for &(id, input, bits) in found {
        let subjects = Subject::<F>::all(&[id]);
        let around: Vec<F> = (bits - 64..=bits + 64).map(F::of_bits).collect();
        let broken = broken(&subjects, &judge(&subjects, input, &around));
        assert!(broken.is_empty(), "{}", broken.join("\n"));
    }
}

/// Exponent, what the input is, its bits: inputs of `CosPower`.
type Power = (u64, Input, u64);

/// f32: pdf, pdf_solid_angle and sf beside π/2, where a large k multiplies what the words of π/2
/// leave out (3.81 ulp); lambert_weight at a subnormal scale (4.21); warp, warp_sf and isf (2.57).
const POWER_F32: [Power; 7] = [
    (0x407a_d9d0, Input::Angle, 0x3fc9_0fda),
    (0x4082_cd2d, Input::Angle, 0x3fc9_0fda),
    (0x4086_6fb0, Input::Angle, 0x3fc9_0fda),
    (0x7f53_66fb, Input::Sin, 0x2116_7b4e),
    (0x3ddf_25da, Input::Tail, 0x0400_6f19),
    (0x7da3_4694, Input::Tail, 0x3f13_d06c),
    (0x5c95_1f8d, Input::Tail, 0x3f19_f7f6),
];

/// f64: the same, 6.50, 4.25 and 2.59 ulp.
const POWER_F64: [Power; 7] = [
    (0x4032_c8b5_a315_9ac8, Input::Angle, 0x3ff9_21fb_5444_2d18),
    (0x4032_e06a_b57d_2306, Input::Angle, 0x3ff9_21fb_5444_2d18),
    (0x4031_e6c2_b616_27e6, Input::Angle, 0x3ff9_21fb_5444_2d18),
    (0x7feb_abaf_07ec_fa39, Input::Sin, 0x2034_dfbe_4ca4_9e98),
    (0x3fb8_edf8_1d58_1448, Input::Tail, 0x0761_0790_61d6_c2e6),
    (0x76f3_8a0a_c3e7_ddd1, Input::Tail, 0x3fe2_0f7f_0878_d129),
    (0x76d2_8e8e_185a_0155, Input::Tail, 0x3fec_3395_4ceb_a301),
];

/// The same for a lobe, at inputs up to the domain's end.
fn powers_within_their_cells<F: Tiers>(found: &[Power]) {
    for &(k, input, bits) in found {
        let subjects = Subject::<F>::all(&[Id::CosPower(F::of_bits(k).wide())]);
        let last = (bits + 64).min(match input {
            Input::Angle => F::TOP_ANGLE,
            _ => u64::MAX,
        });
        let around: Vec<F> = (bits - 64..=last).map(F::of_bits).collect();
        let broken = broken(&subjects, &judge(&subjects, input, &around));
        assert!(broken.is_empty(), "{}", broken.join("\n"));
    }
}

#[test]
fn worst_inputs_of_powers() {
    powers_within_their_cells::<f32>(&POWER_F32);
    powers_within_their_cells::<f64>(&POWER_F64);
}

/// cos θ = sin θ, which name two directions, at exponents that tell them apart (154 ulp); the least
/// tails in `Fast` (all digits lost); cos θ = 0.
#[test]
fn ties_and_ends_of_powers() {
    for k in [0x3f80_0000, 0x410a_3f10, 0x437a_e542, 0x4386_93b5] {
        let at = |input, bits| (k, input, bits);
        let least = [1, 2, 3, 5, 1 << 10].map(|bits| at(Input::Tail, bits + 64));
        let ends = [at(Input::Angle, 0x3f49_0fdb), at(Input::Cos, 64)];
        powers_within_their_cells::<f32>(&[&least[..], &ends].concat());
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
    let text = include_str!("../../docs/measured/worst_inputs.json");
    let rows = found::from_json(text).expect("rows");
    for law in Id::FIXED {
        let searched = |tier: &str| rows.iter().any(|r| r.tier == tier && r.law == law.name());
        assert!(searched("f64") && searched("Precise<f64>"), "{law:?}");
    }
    for tier in ["f32", "f64", "Precise<f32>", "Precise<f64>", "Fast<f32>"] {
        let of_power = |r: &&Found| r.tier == tier && r.law == "CosPower";
        assert_eq!(
            rows.iter().filter(of_power).count(),
            OPERATIONS.len(),
            "{tier}"
        );
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
    let text = include_str!("../../docs/measured/worst_inputs.json");
    let rows = found::from_json(text).expect("rows");
    let fixed = rows
        .iter()
        .filter(|r| r.tier == "f64" && r.law != "CosPower");
    let worst = fixed
        .max_by(|a, b| a.error.total_cmp(&b.error))
        .expect("rows of f64");
    let headline = format!("| `f64` | simulation | {:.2} ulp, searched |", worst.error);
    assert!(
        include_str!("../../README.md").contains(&headline),
        "{headline}: {worst:?}"
    );
}
