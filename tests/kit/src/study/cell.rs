//! A function bound to its inputs, as both the instruction counter and the clock run it.

use coslobe::rand_core::{Rng, TryRng};
use rand_pcg::Pcg32;
use std::convert::Infallible;
use std::hint::black_box;
use std::rc::Rc;

/// Draws of one run of a sampler: rejection makes their cost a mean, which this many settle to 1 %.
pub const DRAWS: u64 = 4096;

/// The generator that all samplers, ours and the peers', draw from.
pub fn generator() -> Pcg32 {
    Pcg32::new(black_box(0x853C_49E6_748F_EA9B), 0xDA3E_39CB_94B9_5BDB)
}

/// Something that draws from a generator, whichever it is.
pub trait Draw: Copy + 'static {
    type Out: Default + 'static;
    /// To be inlined: this wrapper shall cost nothing of its own.
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> Self::Out;
    /// cos θ of what was drawn, θ from the axis +y.
    fn cos(out: &Self::Out) -> f64;
}

/// Arguments to count over, and arguments to time over.
#[derive(Clone)]
pub struct Inputs<A> {
    /// Few, and stratified to the ends of the domain.
    pub counted: Rc<[A]>,
    /// Many, even over the domain and shuffled: branches are as hard to foresee as in use.
    pub timed: Rc<[A]>,
}

/// One run of a function over its inputs, and of the same loop without the function.
pub struct Cell {
    pub run: Box<dyn FnMut()>,
    pub empty: Box<dyn FnMut()>,
    /// Calls of one such run.
    pub calls: u64,
    pub timed: Box<dyn FnMut()>,
    pub timed_calls: u64,
    pub words: Option<Words>,
    /// Mean cos θ of what was drawn.
    pub mean_cos: Option<f64>,
}

impl Cell {
    /// A pure function on given inputs.
    pub fn of<A: Copy + 'static, B: Default + 'static>(
        inputs: &Inputs<A>,
        f: impl Fn(A) -> B + Copy + 'static,
    ) -> Cell {
        let Inputs { counted, timed } = inputs.clone();
        let same = counted.clone();
        Cell {
            calls: counted.len() as u64,
            timed_calls: timed.len() as u64,
            run: Box::new(move || each(&counted, f)),
            empty: Box::new(move || {
                for &x in &*same {
                    black_box(x);
                    black_box(B::default());
                }
            }),
            timed: Box::new(move || each(&timed, f)),
            words: None,
            mean_cos: None,
        }
    }

    fn words<W: Default + 'static>(next: impl Fn(&mut Pcg32) -> W + Copy + 'static) -> Cell {
        let words = move || {
            let mut rng = generator();
            for _ in 0..DRAWS {
                black_box(next(&mut rng));
            }
        };
        Cell {
            run: Box::new(words),
            empty: Box::new(|| {
                for _ in 0..DRAWS {
                    black_box(W::default());
                }
            }),
            calls: DRAWS,
            timed: Box::new(words),
            timed_calls: DRAWS,
            words: None,
            mean_cos: None,
        }
    }

    /// A sampler with its generator: the generator's instructions are part of the cost.
    pub fn drawing<D: Draw>(sampler: D) -> Cell {
        // Never started again: a repeated sequence would teach the branch predictor each rejection.
        let mut endless = generator();
        let (words, mean_cos) = Words::of(sampler);
        Cell {
            run: Box::new(move || draws(sampler, &mut generator())),
            empty: Box::new(|| {
                for _ in 0..DRAWS {
                    black_box(D::Out::default());
                }
            }),
            calls: DRAWS,
            timed: Box::new(move || draws(sampler, &mut endless)),
            timed_calls: DRAWS,
            words: Some(words),
            mean_cos: Some(mean_cos),
        }
    }
}

/// The generator alone: a `next_u32`, a `next_u64`.
pub fn generator_cells() -> [Cell; 2] {
    [
        Cell::words(|rng| rng.next_u32()),
        Cell::words(|rng| rng.next_u64()),
    ]
}

#[inline(always)]
fn each<A: Copy, B>(inputs: &[A], f: impl Fn(A) -> B) {
    for &x in inputs {
        black_box(f(black_box(x)));
    }
}

#[inline(always)]
fn draws(sampler: impl Draw, rng: &mut Pcg32) {
    // A copy, so that its state is in registers as in any inner loop.
    let mut local = rng.clone();
    for _ in 0..DRAWS {
        black_box(sampler.draw(&mut local));
    }
    *rng = local;
}

/// Mean calls of the generator per sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Words {
    pub next_u32: f64,
    pub next_u64: f64,
}

impl Words {
    /// With the mean of cos θ.
    fn of<D: Draw>(sampler: D) -> (Words, f64) {
        let mut counter = Counter {
            rng: generator(),
            next_u32: 0,
            next_u64: 0,
        };
        let sum: f64 = (0..DRAWS)
            .map(|_| D::cos(&sampler.draw(&mut counter)))
            .sum();
        let words = Words {
            next_u32: counter.next_u32 as f64 / DRAWS as f64,
            next_u64: counter.next_u64 as f64 / DRAWS as f64,
        };
        (words, sum / DRAWS as f64)
    }
}

/// Counts what is drawn through it.
struct Counter {
    rng: Pcg32,
    next_u32: u64,
    next_u64: u64,
}

impl TryRng for Counter {
    type Error = Infallible;

    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        self.next_u32 += 1;
        self.rng.try_next_u32()
    }

    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        self.next_u64 += 1;
        self.rng.try_next_u64()
    }

    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        self.next_u32 += bytes.len().div_ceil(4) as u64;
        self.rng.try_fill_bytes(bytes)
    }
}
