//! Sweeps every operation of every subject over inputs.

use super::format::Format;
use super::inputs::stratified;
use super::op::AT_ANGLE;
use super::part::Part;
use super::slots::{Slot, angle_slots, tail_slots};
use super::subject::Subject;
use super::tally::{Place, Tally};
use super::truth::{BLOCK, Truth};
use super::truths::{Angle, Truths};
use super::wide::HALF_PI;
use rayon::prelude::*;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};
use std::ops::Range;

/// What is put in: an angle in [0, π/2] and its pair, or a probability in [0, ½] from either end,
/// which is the whole domain since 1 − u is exact for u ≥ ½, or a pair by its cosine or sine in [0,
/// 1].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Input {
    #[default]
    Angle,
    Tail,
    Cos,
    Sin,
}

impl Input {
    pub const ALL: [Input; 4] = [Input::Angle, Input::Tail, Input::Cos, Input::Sin];

    pub fn name(self) -> &'static str {
        match self {
            Input::Angle => "theta",
            Input::Tail => "tail",
            Input::Cos => "cos",
            Input::Sin => "sin",
        }
    }

    pub fn top<F: Format>(self) -> u64 {
        match self {
            Input::Angle => F::TOP_ANGLE,
            Input::Tail => F::HALF_BITS,
            Input::Cos | Input::Sin => F::of(1.0).bits(),
        }
    }

    /// Whether the upper end of the range is nearer than the lower.
    fn nears_the_end<F: Format>(self, x: F) -> bool {
        let middle = match self {
            Input::Angle => FRAC_PI_4,
            Input::Cos | Input::Sin => FRAC_1_SQRT_2,
            Input::Tail => f64::INFINITY,
        };
        x.wide() > middle
    }

    fn place<F: Format>(self, x: F) -> Place {
        let x = x.wide();
        Place::new::<F>(match self {
            Input::Angle => x.min(HALF_PI[0] - x + HALF_PI[1]),
            Input::Tail => x,
            Input::Cos | Input::Sin => x.min(((1.0 - x) * (1.0 + x)).sqrt()),
        })
    }
}

/// Working memory of one thread.
struct Bench<F: Format> {
    truths: Truths<F>,
    got: Vec<Vec<F>>,
    places: Vec<Place>,
}

impl<F: Format> Bench<F> {
    fn new() -> Self {
        Bench {
            truths: Truths::new(),
            got: vec![vec![F::default(); BLOCK]; AT_ANGLE.len()],
            places: Vec::new(),
        }
    }

    /// All operations of all subjects at up to `BLOCK` inputs. Neighbours of the same law share its
    /// reference. Ascending inputs between whose places no other lies are judged faster.
    fn block(&mut self, subjects: &[Subject<F>], input: Input, x: &[F], tally: &mut Tally) {
        self.places.clear();
        let (first, last) = (input.place(x[0]), input.place(x[x.len() - 1]));
        let one_side = input.nears_the_end(x[0]) == input.nears_the_end(x[x.len() - 1]);
        let together = one_side && first == last && x.windows(2).all(|w| w[0] < w[1]);
        if together {
            self.places.push(first);
        } else {
            self.places.extend(x.iter().map(|&x| input.place(x)));
        }
        let angles: Vec<_> = match input {
            Input::Tail => Vec::new(),
            _ => x.iter().map(|&x| Angle::at(input, x)).collect(),
        };
        let pairs: Vec<_> = angles.iter().map(|a| a.pair).collect();
        let mut law = None;
        for (s, row) in subjects.iter().zip(&mut tally.0) {
            let anew = law.replace(s.id) != Some(s.id);
            let mut judge = |slot: Slot, got: &mut [F], want: &Truth<F>| {
                let got = &mut got[..x.len()];
                if slot.negated {
                    got.iter_mut().for_each(|y| *y = -*y);
                }
                let stat = &mut row[slot.op as usize];
                if together {
                    stat.judge(input, x, got, want, first);
                } else {
                    stat.judge_scattered(input, x, got, want, &self.places);
                }
            };
            match input {
                Input::Angle | Input::Cos | Input::Sin => {
                    if anew {
                        self.truths.angles(s.id, &angles);
                    }
                    let theta = if input == Input::Angle { Some(x) } else { None };
                    s.law.angles(theta, &pairs, &mut self.got);
                    for (i, slot) in angle_slots(s.id, s.solid, input) {
                        let want = self.truths.of(&slot);
                        judge(slot, &mut self.got[i], want);
                    }
                }
                Input::Tail => {
                    if anew {
                        self.truths.tails(s.id, x);
                    }
                    s.law.tails(x, &mut self.got);
                    for (i, slot) in tail_slots(s.id) {
                        let want = self.truths.of(&slot);
                        judge(slot, &mut self.got[i], want);
                    }
                }
            }
        }
    }
}

/// Judges all subjects at given inputs.
pub fn judge<F: Format>(subjects: &[Subject<F>], input: Input, x: &[F]) -> Tally {
    let (mut bench, mut tally) = (Bench::new(), Tally::new(subjects.len()));
    for block in x.chunks(BLOCK) {
        bench.block(subjects, input, block, &mut tally);
    }
    tally
}

/// Judges the inputs `at(0)`, …, `at(count − 1)` in parallel.
fn over<F: Format>(
    subjects: &[Subject<F>],
    input: Input,
    share: Range<u64>,
    at: impl Fn(u64) -> F + Sync,
    progress: impl Fn(u64) + Sync,
) -> Tally {
    let block = BLOCK as u64;
    let count = share.end - share.start;
    let task = (count / 512).clamp(1, 1 << 19).next_multiple_of(block);
    (0..count.div_ceil(task))
        .into_par_iter()
        .map(|t| {
            let (mut bench, mut tally) = (Bench::new(), Tally::new(subjects.len()));
            let start = share.start + t * task;
            let end = (start + task).min(share.end);
            let mut x = Vec::with_capacity(BLOCK);
            for b in (start..end).step_by(BLOCK) {
                x.clear();
                x.extend((b..(b + block).min(end)).map(&at));
                bench.block(subjects, input, &x, &mut tally);
            }
            progress(end - start);
            tally
        })
        .reduce(|| Tally::new(subjects.len()), Tally::merge)
}

/// Every `stride`-th bit pattern up to the top, aligned to it so that the edge itself is tried, and
/// 0.
pub fn sweep<F: Format>(
    subjects: &[Subject<F>],
    input: Input,
    stride: u64,
    part: Part,
    progress: impl Fn(u64) + Sync,
) -> Tally {
    let top = input.top::<F>();
    let (count, first) = (top / stride + 1, top % stride);
    let tally = over(
        subjects,
        input,
        part.share(count),
        |i| F::of_bits(first + i * stride),
        progress,
    );
    if first == 0 || part.index < part.of {
        return tally;
    }
    tally.merge(judge(subjects, input, &[F::of_bits(0)]))
}

/// Some n stratified inputs.
pub fn sample<F: Format>(
    subjects: &[Subject<F>],
    input: Input,
    n: u64,
    part: Part,
    progress: impl Fn(u64) + Sync,
) -> Tally {
    let (n, top) = (n - n % 3, input.top::<F>());
    let share = part.share(n);
    over(subjects, input, share, |i| stratified(top, i, n), progress)
}
