//! Statistics of errors: kept by subject and operation, merged over threads.

use super::format::{Format, ulp};
use super::measure::Input;
use super::op::OPERATIONS;
use super::truth::Truth;
use super::wide::Wide;

/// Bins of the stability picture: one decade of the input each for f32, seven for f64.
pub const BINS: usize = 48;

/// How many misrounded inputs are kept: the smallest.
pub const KEPT: usize = 4;

/// Where an input lies: the bin of its distance to the nearer end, and whether it is in the tail.
///
/// The distance is p itself for a probability, the smaller of θ and π/2 − θ for an angle; the
/// tail is where that is at most 2⁻²⁰.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    bin: usize,
    tail: bool,
}

impl Place {
    pub fn new<F: Format>(distance: f64) -> Self {
        let bin = (-distance.log10() / F::BIN).max(0.0) as usize;
        Place {
            bin: bin.min(BINS - 1),
            tail: distance <= 2f64.powi(-20),
        }
    }
}

/// What is known of one operation of one subject.
#[derive(Clone, Debug)]
pub struct Stat {
    pub ulps: f64,
    /// Bits of the worst argument, and of what they are.
    pub input: u64,
    pub of: Input,
    pub tried: u64,
    /// How many results were the nearest number.
    pub correct: u64,
    pub ties: u64,
    /// Bits of the least arguments whose results were not.
    pub misrounded: Vec<u64>,
    /// Largest |error| over the true value, or over the least normal number where that is larger:
    /// of all inputs, of those in the tail, and by bin (negative where none was tried).
    pub relative: f64,
    pub relative_tail: f64,
    pub bins: [f64; BINS],
}

impl Default for Stat {
    fn default() -> Self {
        Stat {
            ulps: 0.0,
            input: 0,
            of: Input::default(),
            tried: 0,
            correct: 0,
            ties: 0,
            misrounded: Vec::new(),
            relative: 0.0,
            relative_tail: 0.0,
            bins: [-1.0; BINS],
        }
    }
}

impl Stat {
    pub fn misrounded_count(&self) -> u64 {
        self.tried - self.correct
    }

    /// Judges results that all lie at one place. The first pass only asks whether anything is new.
    pub fn judge<F: Format>(
        &mut self,
        of: Input,
        inputs: &[F],
        got: &[F],
        want: &Truth<F>,
        place: Place,
    ) {
        let n = inputs.len();
        let (value, lift) = (&want.value[..n], &want.lift[..n]);
        let (per_ulp, per_value) = (&want.per_ulp[..n], &want.per_value[..n]);
        let (nearest, got) = (&want.nearest[..n], &got[..n]);
        let (ulps, relative) = (self.ulps, self.bins[place.bin]);
        let (mut news, mut correct) = (false, 0);
        for i in 0..n {
            let error = value[i].minus(got[i].lifted(lift[i])).abs();
            news |= exceeds(error * per_ulp[i], ulps) | exceeds(error * per_value[i], relative);
            correct += u64::from(got[i] == nearest[i]);
        }
        self.tried += n as u64;
        self.correct += correct;
        self.ties += want.ties;
        let all_kept = self.misrounded.len() == KEPT;
        if news
            || (correct < n as u64 && !(all_kept && inputs[0].bits() > self.misrounded[KEPT - 1]))
        {
            for i in 0..n {
                self.look((of, inputs[i]), got[i], want, i, place);
            }
        }
    }

    /// Judges results one by one, each at its own place.
    pub fn judge_scattered<F: Format>(
        &mut self,
        of: Input,
        inputs: &[F],
        got: &[F],
        want: &Truth<F>,
        places: &[Place],
    ) {
        for (i, &input) in inputs.iter().enumerate() {
            self.tried += 1;
            self.correct += u64::from(got[i] == want.nearest[i]);
            self.ties += u64::from(want.tie[i]);
            self.look((of, input), got[i], want, i, places[i]);
        }
    }

    fn look<F: Format>(
        &mut self,
        (of, input): (Input, F),
        got: F,
        want: &Truth<F>,
        i: usize,
        place: Place,
    ) {
        let right = got == want.nearest[i];
        let mut error = want.value[i].minus(got.lifted(want.lift[i])).abs();
        if got.wide() == f64::INFINITY && want.value[i].near().is_finite() {
            // ∞ stands for the first number beyond the largest.
            let beyond = ulp::<F>(F::MAX_VALUE) / 2.0;
            error = want.value[i].minus(F::MAX_VALUE).abs() + beyond;
        }
        let or_infinite = |x: f64| match x.is_nan() {
            true if right => 0.0, // both infinite
            true => f64::INFINITY,
            false => x,
        };
        let mut ulps = or_infinite(error * want.per_ulp[i]);
        if right {
            // What the reference's own error may add to the half.
            ulps = if got.wide().is_finite() {
                ulps.min(0.5)
            } else {
                0.0
            };
        } else {
            self.keep(input.bits());
        }
        let relative = if got.wide().is_finite() || !right {
            or_infinite(error * want.per_value[i])
        } else {
            0.0
        };
        if ulps > self.ulps {
            (self.ulps, self.input, self.of) = (ulps, input.bits(), of);
        }
        let bin = &mut self.bins[place.bin];
        *bin = bin.max(relative);
        self.relative = self.relative.max(relative);
        if place.tail {
            self.relative_tail = self.relative_tail.max(relative);
        }
    }

    fn keep(&mut self, input: u64) {
        if let Err(at) = self.misrounded.binary_search(&input)
            && at < KEPT
        {
            self.misrounded.insert(at, input);
            self.misrounded.truncate(KEPT);
        }
    }

    fn merge(&mut self, other: &Self) {
        if other.ulps > self.ulps {
            (self.ulps, self.input, self.of) = (other.ulps, other.input, other.of);
        }
        self.tried += other.tried;
        self.correct += other.correct;
        self.ties += other.ties;
        other.misrounded.iter().for_each(|&input| self.keep(input));
        self.relative = self.relative.max(other.relative);
        self.relative_tail = self.relative_tail.max(other.relative_tail);
        for (a, b) in self.bins.iter_mut().zip(other.bins) {
            *a = a.max(b);
        }
    }
}

/// Above the limit, or NaN.
#[inline(always)]
fn exceeds(x: f64, limit: f64) -> bool {
    (x > limit) | x.is_nan()
}

/// Statistics by subject and operation.
#[derive(Clone, Debug)]
pub struct Tally(pub Vec<[Stat; OPERATIONS.len()]>);

impl Tally {
    pub fn new(subjects: usize) -> Self {
        Tally(vec![Default::default(); subjects])
    }

    /// What `each` finds at every kind of input.
    pub fn over_inputs(each: impl FnMut(Input) -> Tally) -> Self {
        let all = Input::ALL.into_iter().map(each);
        all.reduce(Tally::merge).expect("kinds of input")
    }

    pub fn merge(mut self, other: Self) -> Self {
        for (mine, theirs) in self.0.iter_mut().zip(&other.0) {
            for (a, b) in mine.iter_mut().zip(theirs) {
                a.merge(b);
            }
        }
        self
    }
}
