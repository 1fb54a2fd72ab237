//! Time, as ratios alone: all contenders for an operation in interleaved rounds on one core.

use crate::contender::{Contender, whole};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// Rounds over a group; the quickest of a contender counts.
pub(crate) const ROUNDS: usize = 50;
/// Shortest time that a contender is timed for in a round.
const SLICE: Duration = Duration::from_micros(300);

/// Nanoseconds per call, for ratios within one operation of one law.
pub(crate) fn times(contenders: &mut [Contender], step: impl Fn()) -> Vec<f64> {
    let mut groups: BTreeMap<(String, &str), Vec<usize>> = BTreeMap::new();
    for (i, c) in contenders.iter().enumerate() {
        let key = (c.law.to_string(), whole(c.operation));
        groups.entry(key).or_default().push(i);
    }
    let mut best = vec![f64::INFINITY; contenders.len()];
    for members in groups.values() {
        let repeats: Vec<u32> = members
            .iter()
            .map(|&i| repeats(&mut contenders[i]))
            .collect();
        for _ in 0..ROUNDS {
            for (&i, &n) in members.iter().zip(&repeats) {
                let c = &mut contenders[i];
                let calls = f64::from(n) * c.cell.timed_calls as f64;
                let ns = timed(c, n).as_secs_f64() * 1e9 / calls;
                best[i] = best[i].min(ns);
            }
        }
        members.iter().for_each(|_| step());
    }
    best
}

fn timed(c: &mut Contender, n: u32) -> Duration {
    // Once before, for the data that the others have pushed out of the caches.
    (c.cell.timed)();
    let start = Instant::now();
    for _ in 0..n {
        (c.cell.timed)();
    }
    start.elapsed()
}

/// Runs that fill a slice.
fn repeats(c: &mut Contender) -> u32 {
    let mut n = 1;
    while timed(c, n) < SLICE {
        n *= 2;
    }
    n
}
