//! Counts the instructions of calls through a pointer.

use crate::generator::Generator;
use board::{Ticks, arguments, print, println, stack};
use core::hint::black_box;

/// Calls that are counted together: with them, half a tick is an eighth of an instruction.
const REPEATS: u32 = 256;

/// What to count, and the counter.
pub struct Meter<'a> {
    ticks: Ticks,
    law: &'static str,
    /// Only this law and operation, if the command line names them.
    only: [Option<&'a str>; 2],
}

/// Counts all of `operations`, or the law and the operation on the command line.
pub fn run(operations: impl FnOnce(&mut Meter)) -> ! {
    let words = arguments();
    words.next(); // the image's name
    let only = [words.next(), words.next()];
    println!("count {} {REPEATS}", Ticks::INSTRUCTIONS_IN_TWO);
    operations(&mut Meter {
        ticks: Ticks::start(),
        law: "",
        only,
    });
    println!("done");
    board::exit(true)
}

/// What a line says besides the counts.
struct Operation<'a> {
    name: &'a str,
    address: usize,
    /// Words of 32 bits that it draws.
    words: u32,
}

impl Meter<'_> {
    /// What follows is of this law.
    pub fn law(&mut self, name: &'static str) {
        self.law = name;
    }

    /// A function of a law and an argument; `nothing` returns at once.
    pub fn call<L, A: Copy, B>(
        &mut self,
        operation: &str,
        law: &L,
        inputs: &[A],
        f: fn(&L, A) -> B,
        nothing: fn(&L, A) -> B,
    ) {
        let both = [f, nothing];
        let operation = Operation {
            name: operation,
            address: f as usize,
            words: 0,
        };
        self.measure(operation, both, inputs, |f, x| {
            black_box(black_box(f)(black_box(law), black_box(*x)));
        });
    }

    /// A sampler, drawing from the same states of a generator as every other.
    pub fn draw<R: Generator, L, B>(
        &mut self,
        law: &L,
        f: fn(&L, &mut R) -> B,
        nothing: fn(&L, &mut R) -> B,
    ) {
        self.draw_as(R::OPERATION, law, f, nothing);
    }

    /// As [`draw`](Meter::draw), an operation of another name.
    pub fn draw_as<R: Generator, L, B>(
        &mut self,
        operation: &str,
        law: &L,
        f: fn(&L, &mut R) -> B,
        nothing: fn(&L, &mut R) -> B,
    ) {
        let states = R::states();
        let words = |state: &R| {
            let mut rng = state.clone();
            f(law, &mut rng);
            R::words(state, &rng)
        };
        let words = states.iter().map(words).max().unwrap_or(0);
        let both = [f, nothing];
        let subject = Operation {
            name: operation,
            address: f as usize,
            words,
        };
        self.measure(subject, both, &states, |f, state| {
            let mut rng = state.clone();
            black_box(black_box(f)(black_box(law), black_box(&mut rng)));
        });
    }

    /// `once` calls one of the two functions.
    #[inline(always)]
    fn measure<F: Copy, A>(
        &mut self,
        operation: Operation,
        [f, nothing]: [F; 2],
        inputs: &[A],
        once: impl Fn(F, &A) + Copy,
    ) {
        let skipped = |only: Option<&str>, name| only.is_some_and(|o| o != name);
        if skipped(self.only[0], self.law) || skipped(self.only[1], operation.name) {
            return;
        }
        let depth = |f| inputs.iter().map(|x| stack(&mut || once(f, x))).max();
        let (own, base) = (depth(f).unwrap_or(0), depth(nothing).unwrap_or(0));
        // Arm marks Thumb code by an odd address.
        let address = operation.address & !1;
        print!("{} {} {address:#x}", self.law, operation.name);
        print!(" {} {own},{base}", operation.words);
        print!(" {}", self.repeat(nothing, &inputs[0], once));
        for (i, x) in inputs.iter().enumerate() {
            let separator = if i == 0 { ' ' } else { ',' };
            print!("{separator}{}", self.repeat(f, x, once));
        }
        println!();
    }

    #[inline(never)]
    fn repeat<F: Copy, A>(&mut self, f: F, x: &A, once: impl Fn(F, &A)) -> u32 {
        // From the edge of a tick, so that the count is short of the truth by half a tick in the
        // mean.
        self.ticks.restart();
        while self.ticks.elapsed() == 0 {}
        self.ticks.restart();
        for _ in 0..REPEATS {
            once(f, x);
        }
        self.ticks.elapsed()
    }
}
