//! The laws in integers beside closed `f64` forms.

pub mod reference;
pub mod short;
pub mod truth;

use crate::catalogue::IntegerLaw;
use crate::stats::claim::{Claim, Direction};
use coslobe::rand_core::Rng;
use coslobe::{Fixed, Fixed16, Moments};

/// What the documentation of `coslobe::integers` says of a law's errors in one format: the table
/// after the words `Those of` its name, largest errors in units of the last place by operation.
/// What follows a number in a cell is its input.
pub fn documented(format: &str) -> Vec<(String, Vec<f64>)> {
    const PAGE: &str = include_str!("../../../../src/integers/mod.rs");
    let rows = PAGE
        .lines()
        .skip_while(|line| !line.contains(&format!("Those of `{format}`")));
    let rows = rows.map_while(|line| line.strip_prefix("//!"));
    let rows = rows
        .map(str::trim)
        .skip_while(|line| !line.starts_with("|---"));
    let rows = rows.skip(1).take_while(|line| line.starts_with('|'));
    let rows = rows.map(|row| {
        let mut cells = row.trim_matches('|').split('|').map(str::trim);
        let law = cells
            .next()
            .unwrap_or_default()
            .trim_matches('`')
            .to_owned();
        let number = |cell: &str| cell.split(' ').next()?.parse().ok();
        (law, cells.filter_map(number).collect())
    });
    rows.collect()
}

/// A format of integers.
pub trait Format {
    /// The type's name.
    const NAME: &'static str;
    /// The unit in the last place of a component.
    const UNIT: f64;
    /// How far from 1 a direction's length may be, and its components' error.
    const LENGTH: f64;
    /// A sample.
    fn sample<L: IntegerLaw>(law: L, rng: &mut dyn Rng) -> Direction;
    /// What a law of a power k claims, whose distances below 1/256 are judged relative to it:
    /// cosines are a unit apart.
    fn claim(name: &str, planar: bool, k: f64, moments: Moments<f64>) -> Claim {
        Claim {
            name: format!("{}({name})", Self::NAME),
            planar,
            k,
            moments,
            epsilon: Self::UNIT,
            length: Self::LENGTH,
            error: Self::LENGTH,
            grid: Self::grid(k),
        }
    }
    /// Of two tails below 1/256 as many are equal as if cosines were relatively this far apart.
    fn grid(k: f64) -> f64;
}

/// 32 bits.
pub struct Long;

impl Format for Long {
    const NAME: &'static str = "Fixed";
    const UNIT: f64 = 1.0 / reference::Q31;
    const LENGTH: f64 = 4.0 * Self::UNIT;
    fn sample<L: IntegerLaw>(law: L, rng: &mut dyn Rng) -> Direction {
        direction(Fixed(law).sample(rng).as_ref())
    }
    fn grid(_: f64) -> f64 {
        256.0 * Self::UNIT
    }
}

/// 16 bits.
pub struct Short;

impl Format for Short {
    const NAME: &'static str = "Fixed16";
    const UNIT: f64 = 1.0 / short::Q15;
    const LENGTH: f64 = 2.0 * Self::UNIT;
    fn sample<L: IntegerLaw>(law: L, rng: &mut dyn Rng) -> Direction {
        direction(Fixed16(law).sample(rng).as_ref())
    }
    fn grid(k: f64) -> f64 {
        if k == 0.0 {
            128.0 * Self::UNIT
        } else {
            16.0 * Self::UNIT
        }
    }
}

/// Components as numbers; those of the plane lie at z = 0.
pub fn direction<C: Copy + Into<f64>>(components: &[C]) -> Direction {
    let mut direction = [0.0; 3];
    for (to, &from) in direction.iter_mut().zip(components) {
        *to = from.into();
    }
    direction
}
