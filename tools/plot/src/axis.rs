//! An axis whose ticks and labels are given.

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, ValueFormatter};
use plotters::prelude::Ranged;
use std::ops::Range;

/// plotters' own axes choose their ticks by a rule that knows neither degrees nor tails.
pub struct Axis {
    range: Range<f64>,
    ticks: Vec<f64>,
    label: fn(f64) -> String,
}

impl Axis {
    pub fn new(range: Range<f64>, ticks: Vec<f64>, label: fn(f64) -> String) -> Axis {
        Axis {
            range,
            ticks,
            label,
        }
    }

    /// Ticks at the multiples of `step`.
    pub fn stepped(range: Range<f64>, step: f64) -> Axis {
        let first = (range.start / step - 1e-9).ceil() as i32;
        let last = (range.end / step + 1e-9).floor() as i32;
        let ticks = (first..=last).map(|i| f64::from(i) * step).collect();
        Axis::new(range, ticks, short)
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (low, high): (i32, i32)) -> i32 {
        let share = (value - self.range.start) / (self.range.end - self.range.start);
        low + (share * f64::from(high - low)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> Range<f64> {
        self.range.clone()
    }
}

impl ValueFormatter<f64> for Axis {
    fn format_ext(&self, value: &f64) -> String {
        (self.label)(*value)
    }
}

/// The largest of 1, 2, 5 times a power of ten that is not above x > 0.
pub fn round_down(x: f64) -> f64 {
    let unit = 10f64.powf(x.log10().floor());
    let step = [5.0, 2.0].into_iter().find(|m| m * unit <= x);
    step.unwrap_or(1.0) * unit
}

/// A number in a few characters.
pub fn short(x: f64) -> String {
    let shown = if x != 0.0 && !(1e-3..1e4).contains(&x.abs()) {
        format!("{x:.1e}")
    } else {
        // Three decimals, without the noise of a multiple of 0.1.
        format!("{}", (x * 1e3).round() / 1e3)
    };
    shown.replace('-', "−")
}

/// 10ᵉ in superscripts.
pub fn power_of_ten(exponent: f64) -> String {
    if exponent == 0.0 {
        return "1".to_owned();
    }
    format!("10{}", superscript(exponent))
}

/// A whole number in superscripts.
pub fn superscript(n: f64) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
    };
    format!("{n:.0}").chars().map(raised).collect()
}
