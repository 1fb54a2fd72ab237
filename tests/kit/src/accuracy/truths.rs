//! All true values of a law over a block of inputs.

use super::format::Format;
use super::inverse::{angle, warp};
use super::measure::Input;
use super::reference::{Direction, Formula, Id};
use super::slots::{OF_PAIR, Slot};
use super::truth::Truth;
use super::wide::Wide;
use coslobe::CosSin;

/// What all laws share at an angle, or at a pair.
pub struct Angle<F: Format> {
    pub theta: F,
    pub pair: CosSin<F>,
    /// Nothing of θ is judged where a pair was put in.
    at: Option<Direction<F::Wide>>,
    paired: Direction<F::Wide>,
}

impl<F: Format> Angle<F> {
    pub fn new(theta: F) -> Self {
        let at = Direction::<F::Wide>::at_angle(theta.wide()).with_logs();
        let (cos, sin) = (F::of(at.cos.near()), F::of(at.sin.near()));
        Angle {
            theta,
            pair: CosSin { cos, sin },
            at: Some(at),
            paired: Direction::at_pair(cos.wide(), sin.wide()),
        }
    }

    /// The pair whose cosine or sine is `x`, the other component rounded.
    pub fn of_component(x: F, is_cos: bool) -> Self {
        let (one, x_wide) = (F::Wide::of(1.0), F::Wide::of(x.wide()));
        let other = F::of((one - x_wide * x_wide).root().near());
        let (cos, sin) = if is_cos { (x, other) } else { (other, x) };
        let paired = Direction::<F::Wide>::at_pair(cos.wide(), sin.wide());
        Angle {
            theta: F::of(paired.theta.near()),
            pair: CosSin { cos, sin },
            at: None,
            paired,
        }
    }

    /// What is judged at the input `x`.
    pub fn at(input: Input, x: F) -> Self {
        match input {
            Input::Angle | Input::Tail => Self::new(x),
            Input::Cos | Input::Sin => Self::of_component(x, input == Input::Cos),
        }
    }
}

/// pdf, ln pdf, density at θ, then (of the pair) density and weight, tails at θ and of the pair.
fn at_angle<W: Wide>(
    f: &Formula<W>,
    at: &Direction<W>,
    paired: &Direction<W>,
    pair_cos: f64,
) -> [W; 9] {
    let (lower, upper) = f.tails(at);
    let [density, weight, pair_lower, pair_upper] = at_pair(f, paired, pair_cos);
    [
        f.pdf(at),
        f.ln_pdf(at),
        f.density(at),
        density,
        weight,
        lower,
        upper,
        pair_lower,
        pair_upper,
    ]
}

/// Density, weight and tails of a pair.
fn at_pair<W: Wide>(f: &Formula<W>, paired: &Direction<W>, pair_cos: f64) -> [W; 4] {
    let reads_both = matches!(f.law, Id::CosPower(_));
    let from_cos = if reads_both {
        *paired
    } else {
        Direction::at_cos(pair_cos)
    };
    let (lower, upper) = f.tails(paired);
    [
        f.density(&from_cos),
        f.lambert_weight(&from_cos),
        lower,
        upper,
    ]
}

/// cos, sin and θ at the lower tail p of a spatial law, then at the upper; of a planar law the
/// upper.
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
        Input::Angle | Input::Cos | Input::Sin => {
            let pair = Angle::at(input, x).pair;
            let paired = Direction::at_pair(pair.cos.wide(), pair.sin.wide());
            let at = Direction::at_angle(x.wide());
            at_angle(&Formula::new(law), &at, &paired, pair.cos.wide()).to_vec()
        }
        Input::Tail => at_tail(law, x.wide(), true).to_vec(),
    }
}

/// What looks like a tie at a tiny angle, sine or cosine is one only if nothing follows its leading
/// power, and what follows may be too small for any format. It has the same sign 2ˢ times as far
/// from the end, where it is seen: whether the true value lies above `tie` (`true`), below, or on
/// it (`None`).
fn beyond_tie<F: Format>(law: Id, a: &Angle<F>, k: usize, tie: f64) -> Option<bool> {
    let CosSin { cos, sin } = a.pair;
    let at_horizon = a.at.is_none() && cos < sin;
    let distance = match a.at {
        Some(_) => a.theta,
        None if at_horizon => cos,
        None => sin,
    };
    let s = -28 - distance.wide().log2().floor() as i32;
    let tame = !matches!(law, Id::CosPower(exponent) if exponent > 1e3);
    if F::DIGITS != 24 || s <= 0 || !tame {
        return None;
    }
    let up = 2f64.powi(s);
    let at = Direction::<F::Fine>::at_angle((a.theta.wide() * up).min(1.5));
    let small = if at_horizon { cos } else { sin }.wide() * up;
    let large = (1.0 - small * small).sqrt();
    let (cos, paired) = if at_horizon {
        (small, Direction::at_pair(small, large))
    } else {
        (1.0, Direction::at_pair(large, small))
    };
    let value = at_angle(&Formula::new(law), &at, &paired, cos)[k];
    let power = ((value.near() / tie).log2() / f64::from(s)).round();
    let lifted = tie * up.powf(power);
    let beyond = value.minus(lifted) / lifted;
    (beyond.abs() > 1e-25).then_some(beyond > 0.0)
}

/// True values of a law over a block, one for each of what [`slots`](super::slots) refer to.
pub struct Truths<F: Format>(Vec<Truth<F>>);

impl<F: Format> Default for Truths<F> {
    fn default() -> Self {
        Self::new()
    }
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
            let values: [Option<F::Wide>; 9] = match &a.at {
                Some(at) => at_angle(&f, at, &a.paired, cos).map(Some),
                None => {
                    let mut values = [None; 9];
                    for (k, value) in OF_PAIR.into_iter().zip(at_pair(&f, &a.paired, cos)) {
                        values[k] = Some(value);
                    }
                    values
                }
            };
            for (k, want) in values.into_iter().enumerate() {
                let Some(want) = want else { continue };
                let terms = if k == 1 { f.ln_pdf_terms() } else { 0.0 };
                if runs_out::<F>(law, a.theta) && want.near().is_finite() {
                    self.0[k].decide(i, want.near(), terms, fine(k));
                    continue;
                }
                self.0[k].put(i, want, terms, || fine(k));
                if self.0[k].tie[i]
                    && let Some(beyond) = beyond_tie(law, a, k, self.0[k].value[i].near())
                {
                    self.0[k].break_tie(i, beyond);
                }
            }
            if let (Id::CosPower(_), Some(_)) = (law, &a.at) {
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
