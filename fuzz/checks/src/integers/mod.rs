//! The laws in integers: the input chooses an operation, a format and a law, and one promise of
//! theirs is checked.
//!
//! - no word, pair, normal or exponent overflows, panics or leaves its range, with debug assertions
//!   on;
//! - at a probability, an angle, a direction: within a few units of closed forms in `f64` (the
//!   tests of `errors` hold each law to its own bound), and of each other where two operations say
//!   the same;
//! - a sample is a unit vector above the horizon with a positive density, from the documented
//!   number of words, and has the same bits by every way to draw it;
//! - a weight and a point's distance lie within a few units of closed forms;
//! - a frame takes unit vectors alone, keeps lengths and has a way back.

mod format;
mod line;
mod points;
mod space;

use super::input::Input;
use coslobe::integers::{CosPower, Fixed16Spatial, FixedSpatial};
use coslobe::{Fixed, Fixed16};
use fixed::types::U16F16;
use format::Law;
use kit::Id;
use kit::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law};
use line::{angles, draws, pairs, phases, quantiles, warps};

pub fn check(data: &[u8]) {
    let mut input = Input::new(data);
    let k = U16F16::from_bits(input.words.word() as u32);
    let law = input.which_law(Id::ALL.len());
    let mut chosen = Chosen { law, k, input };
    every_integer_law(&mut chosen);
}

/// Counts laws down to the chosen one.
struct Chosen<'a> {
    law: usize,
    k: U16F16,
    input: Input<'a>,
}

impl Chosen<'_> {
    fn found(&mut self) -> bool {
        let found = self.law == 0;
        self.law = self.law.wrapping_sub(1);
        found
    }
}

impl IntegerVisitor for Chosen<'_> {
    fn law<L: IntegerLaw>(&mut self, law: L) {
        if self.found() {
            match self.input.number_type(3) {
                0 => line(Fixed(law), L::ID, self.input.clone()),
                1 => points::distances(law, &mut self.input),
                _ => line(Fixed16(law), L::ID, self.input.clone()),
            }
        }
    }
    fn spatial<L: IntegerLaw + FixedSpatial + Fixed16Spatial>(&mut self, law: L) {
        if self.found() {
            match self.input.number_type(3) {
                0 => space(Fixed(law), L::ID, self.input.clone()),
                1 => points::distances(law, &mut self.input),
                _ => space(Fixed16(law), L::ID, self.input.clone()),
            }
        }
    }
    fn power(&mut self, _: CosPower) {
        if self.found() {
            let id = Id::CosPower(f64::from(self.k));
            space(Fixed(CosPower::new(self.k)), id, self.input.clone());
        }
    }
}

/// What laws in space have beside what all have. Whoever adds an operation adds it here or in
/// `line`.
fn space<L: space::Law>(law: L, id: Id, mut input: Input) {
    match input.operation(12) {
        0 | 1 => space::directions(law, id, &mut input),
        2 => space::back(law, &mut input),
        3 => space::draws(law, &input.words),
        4 => space::around(law, &mut input),
        5 => space::solid_angle(law, &mut input),
        _ => line(law, id, input),
    }
}

fn line<L: Law>(law: L, id: Id, mut input: Input) {
    match input.operation(6) {
        0 => pairs(law, id, &mut input),
        1 => warps(law, id, input.words.word() as u32),
        2 => angles(law, id, input.words.word() as u32),
        3 => quantiles(law, id, input.words.word() as u32),
        4 => draws(law, id, &input.words),
        _ => phases::<L>(input.words.word() as u32),
    }
}
