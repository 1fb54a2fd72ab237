//! The generators that samplers draw from.

use coslobe::rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg32;
use rand_xorshift::XorShiftRng;

/// Draws that a sampler is counted over, each alone.
const DRAWS: usize = 24;

/// More words than a direction takes.
const MANY: u32 = 64;

/// A generator of 32-bit words.
pub trait Generator: Rng + Clone + PartialEq {
    /// The name of drawing a direction from it.
    const OPERATION: &'static str;

    fn new() -> Self;

    /// Where each counted draw begins.
    fn states() -> [Self; DRAWS] {
        let mut rng = Self::new();
        core::array::from_fn(|_| {
            let state = rng.clone();
            for _ in 0..3 {
                rng.next_u32();
            }
            state
        })
    }

    /// Words drawn between two states.
    fn words(from: &Self, to: &Self) -> u32 {
        let mut rng = from.clone();
        for n in 0..MANY {
            if rng == *to {
                return n;
            }
            rng.next_u32();
        }
        panic!("a draw took more than {MANY} words");
    }
}

/// That of the accuracy study.
impl Generator for Pcg32 {
    const OPERATION: &'static str = "sample";

    fn new() -> Self {
        Pcg32::new(0x853C_49E6_748F_EA9B, 0xDA3E_39CB_94B9_5BDB)
    }
}

/// Cheaper where a 64-bit product is a routine.
impl Generator for XorShiftRng {
    const OPERATION: &'static str = "sample_xorshift";

    fn new() -> Self {
        XorShiftRng::from_seed(*b"a seed, not zero")
    }
}
