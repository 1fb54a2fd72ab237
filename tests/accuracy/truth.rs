//! True values of a law over a block of inputs, each with the number of the format nearest to it.
//!
//! The nearest number is certain. A reference value w of relative error EPS (`Wide::EPS`, which the
//! tests show to hold) is taken at both ends of w ± 4·EPS·|w|; where they round differently, the
//! value is taken again in `Format::Fine`, to 1e-28. What is undecided even then, within about
//! 1e-20 ulp of the middle for f32 and 4e-12 for f64, is a tie: true ties exist (1 − 2p, c²), and
//! round to even. Subnormal values round to the subnormal numbers. A quantile beyond the last
//! number of the support has that number as its true value, since by contract it stays inside.

use super::double::Double;
use super::format::{Format, nearest, ulp};
use super::inverse::{angle, warp};
use super::measure::Input;
use super::reference::{Direction, Formula, Id};
use super::subject::{AT_ANGLE, AT_TAIL, Op};
use super::wide::Wide;
use coslobe::CosSin;

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
    fn put(&mut self, i: usize, want: F::Wide, terms: f64, fine: impl FnOnce() -> F::Fine) {
        let near = want.near();
        let margin = MARGIN * F::Wide::EPS * (near.abs() + terms);
        let (below, above) = F::bracket(want, margin);
        if below == above && near.abs() >= F::FLOOR {
            self.store(i, want, near, 1.0, below);
        } else if near.is_finite() {
            self.decide(i, near, terms, fine());
        } else {
            self.store(i, want, near, 1.0, F::round(near));
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
    fn decide(&mut self, i: usize, near: f64, terms: f64, fine: F::Fine) {
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

    /// A logarithm that crosses zero is judged in ulps of 1 around there.
    fn absolute_below_one(&mut self, i: usize) {
        if self.value[i].near().abs() < 1.0 {
            (self.per_ulp[i], self.per_value[i]) = (1.0 / ulp::<F>(1.0), 1.0);
        }
    }

    fn keep_inside(&mut self, i: usize) {
        let top = F::of_bits(F::TOP_ANGLE);
        if self.value[i].near() > top.wide() {
            self.store(i, F::Wide::of(top.wide()), top.wide(), 1.0, top);
        }
    }
}

/// What all laws share at an angle.
pub struct Angle<F: Format> {
    pub theta: F,
    pub pair: CosSin<F>,
    at: Direction<F::Wide>,
    paired: Direction<F::Wide>,
}

impl<F: Format> Angle<F> {
    pub fn new(theta: F) -> Self {
        let at = Direction::<F::Wide>::at_angle(theta.wide()).with_logs();
        let (cos, sin) = (F::round(at.cos.near()), F::round(at.sin.near()));
        Angle {
            theta,
            pair: CosSin { cos, sin },
            at,
            paired: Direction::at_pair(cos.wide(), sin.wide()),
        }
    }
}

/// pdf, ln pdf, density at θ, density and weight of the pair, tails at θ and of the pair.
fn at_angle<W: Wide>(
    f: &Formula<W>,
    at: &Direction<W>,
    paired: &Direction<W>,
    pair_cos: f64,
) -> [W; 9] {
    let reads_both = matches!(f.law, Id::CosPower(_));
    let from_cos = if reads_both {
        *paired
    } else {
        Direction::at_cos(pair_cos)
    };
    let (lower, upper) = f.tails(at);
    let (pair_lower, pair_upper) = f.tails(paired);
    [
        f.pdf(at),
        f.ln_pdf(at),
        f.density(at),
        f.density(&from_cos),
        f.lambert_weight(&from_cos),
        lower,
        upper,
        pair_lower,
        pair_upper,
    ]
}

/// cos, sin and θ at the lower tail p of a spatial law, then at the upper; of a planar law the upper.
fn at_tail<W: Wide>(law: Id, p: f64, angles: bool) -> [W; 6] {
    let side = |upper: bool| {
        let at = warp::<W>(law, p, upper);
        let theta = if angles { angle(law, p, at) } else { at.0 };
        (at.0, at.1, theta)
    };
    let upper = side(true);
    let lower = if law.planar() { upper } else { side(false) };
    [lower.0, lower.1, lower.2, upper.0, upper.1, upper.2]
}

/// θ² underflows before a large exponent multiplies it.
pub fn runs_out<F: Format>(law: Id, theta: F) -> bool {
    F::FLOOR > 0.0 && theta.wide() < 1e-130 && matches!(law, Id::CosPower(_))
}

/// All values of a law at an input, in W.
pub fn values<F: Format, W: Wide>(law: Id, input: Input, x: F) -> Vec<W> {
    match input {
        Input::Angle => {
            let pair = Angle::new(x).pair;
            let paired = Direction::at_pair(pair.cos.wide(), pair.sin.wide());
            let at = Direction::at_angle(x.wide());
            at_angle(&Formula::new(law), &at, &paired, pair.cos.wide()).to_vec()
        }
        Input::Tail => at_tail(law, x.wide(), true).to_vec(),
    }
}

/// True values of a law over a block, one for each entry of what [`slots`] refers to.
pub struct Truths<F: Format>(Vec<Truth<F>>);

/// Which truth a slot of `AT_ANGLE` or `AT_TAIL` is held against, and whether its sign is mirrored.
pub struct Slot {
    pub op: Op,
    pub truth: usize,
    pub negated: bool,
}

pub fn angle_slots(law: Id, solid: bool) -> impl Iterator<Item = (usize, Slot)> {
    // A planar law's references are those of −θ.
    let order: &[usize] = if law.planar() {
        &[0, 1, 2, 3, 4, 6, 5, 8, 7, 5, 6, 7, 8]
    } else {
        &[0, 1, 2, 3, 4, 5, 6, 7, 8]
    };
    let slots = order.iter().enumerate().map(|(i, &truth)| {
        let (op, negated) = (AT_ANGLE[i], false);
        (i, Slot { op, truth, negated })
    });
    slots.filter(move |(_, s)| solid || s.op != Op::PdfSolidAngle)
}

pub fn tail_slots(law: Id) -> impl Iterator<Item = (usize, Slot)> {
    let planar = law.planar();
    let order = if planar {
        [3, 4, 3, 4, 5, 5]
    } else {
        [0, 1, 3, 4, 2, 5]
    };
    order.into_iter().enumerate().map(move |(i, truth)| {
        let op = AT_TAIL[i];
        let negated = planar && matches!(op, Op::WarpSin | Op::Quantile);
        (i, Slot { op, truth, negated })
    })
}

impl<F: Format> Truths<F> {
    pub fn new() -> Self {
        Truths((0..9).map(|_| Truth::new()).collect())
    }

    pub fn of(&self, slot: &Slot) -> &Truth<F> {
        &self.0[slot.truth]
    }

    fn clear(&mut self) {
        self.0.iter_mut().for_each(|t| t.ties = 0);
    }

    pub fn angles(&mut self, law: Id, block: &[Angle<F>]) {
        self.clear();
        let f = Formula::<F::Wide>::new(law);
        let mut fine_formula = None;
        for (i, a) in block.iter().enumerate() {
            let cos = a.pair.cos.wide();
            let mut fine = |k: usize| {
                let f = fine_formula.get_or_insert_with(|| Formula::<F::Fine>::new(law));
                let at = Direction::at_angle(a.theta.wide());
                let paired = Direction::at_pair(cos, a.pair.sin.wide());
                at_angle(f, &at, &paired, cos)[k]
            };
            for (k, want) in at_angle(&f, &a.at, &a.paired, cos).into_iter().enumerate() {
                if runs_out::<F>(law, a.theta) && want.near().is_finite() {
                    self.0[k].decide(i, want.near(), f.ln_pdf_terms(), fine(k));
                    continue;
                }
                let terms = if k == 1 { f.ln_pdf_terms() } else { 0.0 };
                self.0[k].put(i, want, terms, || fine(k));
            }
            if let Id::CosPower(_) = law {
                self.0[1].absolute_below_one(i);
            }
        }
    }

    pub fn tails(&mut self, law: Id, block: &[F]) {
        self.clear();
        for (i, p) in block.iter().enumerate() {
            let p = p.wide();
            let values = at_tail::<F::Wide>(law, p, true);
            for (k, want) in values.into_iter().enumerate() {
                let mirrored = law.planar() && k < 3;
                if !mirrored {
                    let angles = k % 3 == 2;
                    self.0[k].put(i, want, 0.0, || at_tail::<F::Fine>(law, p, angles)[k]);
                    if angles {
                        self.0[k].keep_inside(i);
                    }
                }
            }
        }
    }
}
