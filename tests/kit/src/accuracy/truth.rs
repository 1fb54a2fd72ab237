//! True values of a quantity over a block of inputs, each with the number of the format nearest to
//! it.
//!
//! The nearest number is certain. A reference value w of relative error EPS (`Wide::EPS`, which the
//! tests show to hold) is taken at both ends of w ± 4·EPS·|w|; where they round differently, the
//! value is taken again in `Format::Fine`, to 1e-28. What is undecided even then, within about
//! 1e-20 ulp of the middle for f32 and 4e-12 for f64, is a tie: true ties exist (1 − 2p, c²), and
//! round to even. Subnormal values round to the subnormal numbers. A quantile beyond the last
//! number of the support has that number as its true value, since by contract it stays inside.

use super::double::Double;
use super::format::{Format, nearest, ulp};
use super::wide::Wide;

/// Inputs of a block: what the first-level cache holds.
pub const BLOCK: usize = 128;

const MARGIN: f64 = 4.0;

/// Values below `Format::FLOOR` are kept times 2⁵⁰⁰, and so is what is compared with them.
const LIFT: i32 = 500;

/// The true values of one quantity over a block.
pub struct Truth<F: Format> {
    pub value: Vec<F::Wide>,
    pub lift: Vec<f64>,
    /// Factors from the distance to ulps, and to a relative error.
    pub per_ulp: Vec<f64>,
    pub per_value: Vec<f64>,
    pub nearest: Vec<F>,
    pub tie: Vec<bool>,
    pub ties: u64,
}

impl<F: Format> Default for Truth<F> {
    fn default() -> Self {
        Self::new()
    }
}

impl<F: Format> Truth<F> {
    pub fn new() -> Self {
        Truth {
            value: vec![F::Wide::default(); BLOCK],
            lift: vec![1.0; BLOCK],
            per_ulp: vec![0.0; BLOCK],
            per_value: vec![0.0; BLOCK],
            nearest: vec![F::default(); BLOCK],
            tie: vec![false; BLOCK],
            ties: 0,
        }
    }

    /// Value i of the block; `terms` is the size of what may have cancelled in it.
    #[inline]
    pub fn put(&mut self, i: usize, want: F::Wide, terms: f64, fine: impl FnOnce() -> F::Fine) {
        let near = want.near();
        let margin = MARGIN * F::Wide::EPS * (near.abs() + terms);
        let (below, above) = F::bracket(want, margin);
        if below == above && near.abs() >= F::FLOOR {
            self.store(i, want, near, 1.0, below);
        } else if near.is_finite() {
            self.decide(i, near, terms, fine());
        } else {
            // Infinite, or the exponents of `F::Wide` ran out on the way.
            let fine = fine();
            let far = if fine.near().is_nan() {
                near
            } else {
                fine.near()
            };
            if far.is_finite() {
                self.decide(i, far, terms, fine);
            } else {
                self.store(i, F::Wide::of(far), far, 1.0, F::of(far));
            }
        }
    }

    #[inline]
    fn store(&mut self, i: usize, value: F::Wide, near: f64, lift: f64, nearest: F) {
        let least = f64::MIN_POSITIVE.max(2f64.powi(F::LEAST));
        self.value[i] = value;
        self.lift[i] = lift;
        self.per_ulp[i] = 1.0 / (ulp::<F>(near) * lift);
        self.per_value[i] = 1.0 / (near.abs().max(least) * lift);
        self.nearest[i] = nearest;
        self.tie[i] = false;
    }

    #[cold]
    pub fn decide(&mut self, i: usize, near: f64, terms: f64, fine: F::Fine) {
        let n = if near.abs() < F::FLOOR { LIFT } else { 0 };
        let want = fine.lifted(n);
        let margin = MARGIN * F::Fine::EPS * (want.hi.abs() + terms);
        let end = |m: f64| nearest::<F>(Double::sum(want.hi, 0.0) + Double::sum(want.lo, m), n);
        let (below, above) = (end(-margin), end(margin));
        let tie = below != above;
        let even = if below.bits() % 2 == 0 { below } else { above };
        let value = F::Wide::parts(want.hi, want.lo);
        let nearest = if tie { even } else { below };
        self.store(i, value, want.hi * 2f64.powi(-n), 2f64.powi(n), nearest);
        self.tie[i] = tie;
        self.ties += u64::from(tie);
    }

    /// A tie that is none after all: the true value lies `above` it, or below.
    pub fn break_tie(&mut self, i: usize, above: bool) {
        let (even, tie) = (self.nearest[i], self.value[i].near());
        let bits = even.bits();
        self.nearest[i] = match (even.wide() > tie, above) {
            (true, false) => F::of_bits(bits - 1),
            (false, true) => F::of_bits(bits + 1),
            _ => even,
        };
        self.tie[i] = false;
        self.ties -= 1;
    }

    /// A logarithm that crosses zero is judged in ulps of 1 around there.
    pub fn absolute_below_one(&mut self, i: usize) {
        if self.value[i].near().abs() < 1.0 {
            (self.per_ulp[i], self.per_value[i]) = (1.0 / ulp::<F>(1.0), 1.0);
        }
    }

    pub fn keep_inside(&mut self, i: usize) {
        let top = F::of_bits(F::TOP_ANGLE);
        if self.value[i].near() > top.wide() {
            self.store(i, F::Wide::of(top.wide()), top.wide(), 1.0, top);
        }
    }
}
