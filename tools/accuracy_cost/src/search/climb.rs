//! The search for one law in one number type: blocks of candidates, and hill climbing from the
//! worst.

use super::candidates::{BLOCK, below, block, block_of_power, exponent, moved, step};
use kit::accuracy::bounds::in_unit;
use kit::accuracy::found::{At, Found, errors_at, law_at};
use kit::accuracy::measure::{Input, judge};
use kit::accuracy::op::OPERATIONS;
use kit::accuracy::subject::Subject;
use kit::{Format, Number};
use rand_pcg::Pcg64;
use rand_pcg::rand_core::SeedableRng;
use std::time::{Duration, Instant};

/// Hills that are climbed at a time, of each operation.
const HILLS: usize = 6;

pub(super) struct Search<T: Number> {
    law: String,
    rng: Pcg64,
    /// The worst inputs of each operation, the worst first, no two of one hill.
    hills: [Vec<(f64, At)>; OPERATIONS.len()],
    tried: [u64; OPERATIONS.len()],
    number: std::marker::PhantomData<T>,
}

impl<T: Number> Search<T> {
    /// From what earlier searches found: their inputs, judged anew.
    pub(super) fn new(law: &str, seed: u64, earlier: &[Found]) -> Self {
        let mut search = Search {
            law: law.to_owned(),
            rng: Pcg64::seed_from_u64(seed),
            hills: Default::default(),
            tried: [0; OPERATIONS.len()],
            number: std::marker::PhantomData,
        };
        for found in earlier.iter().filter(|f| f.tier == T::NAME && f.law == law) {
            let op = OPERATIONS
                .iter()
                .position(|(_, name)| *name == found.operation);
            if let (Some(at), Some(op)) = (found.at(), op) {
                search.tried[op] += found.tried;
                let Some(id) = law_at::<T>(law, at.exponent) else {
                    continue;
                };
                for (op, error) in errors_at::<T>(id, at).into_iter().enumerate() {
                    search.offer(op, error, at);
                }
            }
        }
        search
    }

    fn offer(&mut self, op: usize, error: f64, at: At) {
        let same_hill = |other: &At| {
            let near = |a: u64, b: u64| a.abs_diff(b) >> (T::Raw::DIGITS - 8) == 0;
            other.input == at.input
                && near(other.bits, at.bits)
                && near(other.exponent, at.exponent)
        };
        let hills = &mut self.hills[op];
        if let Some(i) = hills.iter().position(|(_, other)| same_hill(other)) {
            if error > hills[i].0 {
                hills[i] = (error, at);
            }
        } else if error > 0.0 && (hills.len() < HILLS || error > hills[HILLS - 1].0) {
            hills.push((error, at));
        }
        hills.sort_by(|a, b| b.0.total_cmp(&a.0));
        hills.truncate(HILLS);
    }

    fn judge(&mut self, input: Input, exponent: u64, x: &[T::Raw]) {
        let Some(id) = law_at::<T>(&self.law, exponent) else {
            return;
        };
        let tally = judge(&[Subject::of::<T>(id)], input, x);
        for (op, stat) in tally.0[0].iter().enumerate() {
            self.tried[op] += stat.tried;
            let at = At {
                input: stat.of,
                bits: stat.input,
                exponent,
            };
            self.offer(op, in_unit(T::NAME, stat), at);
        }
    }

    fn is_power(&self) -> bool {
        self.law == "CosPower"
    }

    fn wander(&mut self) {
        let input = Input::ALL[below(&mut self.rng, 4) as usize];
        let k = if self.is_power() {
            exponent::<T::Raw>(&mut self.rng)
        } else {
            0
        };
        let x = if self.is_power() {
            block_of_power(&mut self.rng, input, T::of_bits(k).wide())
        } else {
            block(&mut self.rng, input)
        };
        self.judge(input, k, &x);
    }

    /// A block around one of the worst inputs of one operation, of those asked for.
    fn climb(&mut self, asked: Option<&str>) {
        let op = below(&mut self.rng, OPERATIONS.len() as u64) as usize;
        let hills = &self.hills[op];
        if hills.is_empty() || asked.is_some_and(|name| name != OPERATIONS[op].1) {
            return;
        }
        let (_, at) = hills[below(&mut self.rng, hills.len() as u64) as usize];
        let largest = <T::Raw as Number>::of(T::Raw::MAX_VALUE).bits();
        let k = if self.is_power() && below(&mut self.rng, 2) == 0 {
            moved(at.exponent, step::<T::Raw>(&mut self.rng), largest)
        } else {
            at.exponent
        };
        let top = at.input.top::<T::Raw>();
        let around = |_| {
            let offset = step::<T::Raw>(&mut self.rng);
            <T::Raw as Number>::of_bits(moved(at.bits, offset, top))
        };
        let x: Vec<T::Raw> = (0..BLOCK).map(around).collect();
        self.judge(at.input, k, &x);
    }

    /// Half of the time far and wide, half of it uphill.
    pub(super) fn run(&mut self, time: Duration, asked: Option<&str>) {
        let end = Instant::now() + time;
        while Instant::now() < end {
            self.wander();
            self.climb(asked);
        }
    }

    /// The worst of each operation.
    pub(super) fn found(&self) -> Vec<Found> {
        let each = OPERATIONS.iter().enumerate().map(|(op, (_, name))| {
            let (error, at) = *self.hills[op].first()?;
            Some(Found {
                tier: T::NAME.to_owned(),
                law: self.law.clone(),
                operation: (*name).to_owned(),
                error: error.min(f64::MAX),
                input: at.input.name().to_owned(),
                bits: format!("{:#x}", at.bits),
                exponent: self.is_power().then(|| format!("{:#x}", at.exponent)),
                tried: self.tried[op],
            })
        });
        each.flatten().collect()
    }
}
