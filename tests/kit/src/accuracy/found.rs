//! The worst inputs that searches found, as `docs/measured/worst_inputs.json` keeps them.

use super::bounds::in_unit;
use super::measure::{Input, judge};
use super::op::OPERATIONS;
use super::reference::Id;
use super::subject::Subject;
use crate::catalogue::every_number;
use crate::{Number, NumberVisitor};
use serde::{Deserialize, Serialize};

/// The worst input of an operation of a law in a number type.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Found {
    #[serde(rename = "type")]
    pub tier: String,
    pub law: String,
    pub operation: String,
    /// In the unit of the table of allowed errors.
    pub error: f64,
    /// What the input is: theta, tail, cos or sin.
    pub input: String,
    /// Its bits, in hex.
    pub bits: String,
    /// Those of `CosPower`'s exponent.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub exponent: Option<String>,
    /// Inputs tried.
    pub tried: u64,
}

/// An input of an operation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct At {
    pub input: Input,
    pub bits: u64,
    /// Bits of `CosPower`'s exponent; else 0.
    pub exponent: u64,
}

/// The law of the bits of an exponent, for the law's name in the table of allowed errors.
pub fn law_at<T: Number>(law: &str, exponent: u64) -> Option<Id> {
    let fixed = Id::FIXED.into_iter().find(|id| id.name() == law);
    let power = || Id::CosPower(T::of_bits(exponent).wide());
    fixed.or_else(|| (law == "CosPower").then(power))
}

/// The errors of all operations of a law at one input; 0 for those that do not read such an input.
pub fn errors_at<T: Number>(id: Id, at: At) -> [f64; OPERATIONS.len()] {
    let subject = [Subject::of::<T>(id)];
    let x = <T::Raw as Number>::of_bits(at.bits);
    judge(&subject, at.input, &[x]).0[0]
        .each_ref()
        .map(|stat| in_unit(T::NAME, stat))
}

impl Found {
    pub fn key(&self) -> [&str; 3] {
        [&self.tier, &self.law, &self.operation]
    }

    pub fn at(&self) -> Option<At> {
        let hex = |text: &str| u64::from_str_radix(text.strip_prefix("0x")?, 16).ok();
        let exponent = self.exponent.as_deref().map_or(Some(0), hex)?;
        Some(At {
            input: Input::ALL.into_iter().find(|i| i.name() == self.input)?,
            bits: hex(&self.bits)?,
            exponent,
        })
    }

    /// The error at the same input today; `None` if the row names nothing that exists.
    pub fn again(&self) -> Option<f64> {
        struct Again<'a>(&'a Found, Option<f64>);
        impl NumberVisitor for Again<'_> {
            fn number<T: Number>(&mut self) {
                let Again(found, error) = self;
                if found.tier == T::NAME {
                    *error = found.error_in::<T>();
                }
            }
        }
        let mut again = Again(self, None);
        every_number(&mut again);
        again.1
    }

    fn error_in<T: Number>(&self) -> Option<f64> {
        let names = &mut OPERATIONS.iter();
        let (op, _) = names.find(|(_, name)| *name == self.operation)?;
        let at = self.at()?;
        Some(errors_at::<T>(law_at::<T>(&self.law, at.exponent)?, at)[*op as usize])
    }
}

/// One row a line: git shows what changed.
pub fn to_json(rows: &[Found]) -> serde_json::Result<String> {
    let lines: Result<Vec<_>, _> = rows.iter().map(serde_json::to_string).collect();
    Ok(format!("[\n{}\n]\n", lines?.join(",\n")))
}

pub fn from_json(text: &str) -> serde_json::Result<Vec<Found>> {
    serde_json::from_str(text)
}
