//! Number types: C's and Rust's type of each role, and the way from one to the other.

use crate::{LAWS, Law};
use Number::{F32, Fast, Q15, Q31};

#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Number {
    F32,
    Fast,
    Q31,
    Q15,
}

/// What a number stands for.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Role {
    Component,
    Probability,
    Angle,
    Density,
    Weight,
    Length,
    Exponent,
    /// A cosine and a sine.
    Pair,
}

impl Number {
    pub(crate) const ALL: [Number; 4] = [F32, Fast, Q31, Q15];

    pub(crate) fn name(self) -> &'static str {
        match self {
            F32 => "f32",
            Fast => "fast",
            Q31 => "q31",
            Q15 => "q15",
        }
    }

    pub(crate) fn title(self) -> &'static str {
        match self {
            F32 => "float: at most 4 units in the last place off",
            Fast => "float to half its digits (relative error 2^-12): cheaper without an FPU",
            Q31 => "32-bit integers: no floating-point instruction or routine is linked",
            Q15 => "16-bit integers: a third of the instructions on a Cortex-M0",
        }
    }

    pub(crate) fn is_integer(self) -> bool {
        matches!(self, Q31 | Q15)
    }

    /// The type whose C types it has.
    pub(crate) fn base(self) -> &'static str {
        match self {
            Fast => "f32",
            other => other.name(),
        }
    }

    /// How many words the handle of `cos_power` takes, if there is one.
    pub(crate) fn handle_words(self) -> Option<usize> {
        match self {
            F32 | Fast => Some(24),
            Q31 => Some(10),
            Q15 => None,
        }
    }

    pub(crate) fn laws(self) -> impl Iterator<Item = Law> {
        let laws = LAWS.into_iter();
        laws.filter(move |law| !law.has_handle() || self.handle_words().is_some())
    }

    /// Rust's type of a component.
    pub(crate) fn rust_component(self) -> &'static str {
        match self {
            F32 => "f32",
            Fast => "Fast<f32>",
            Q31 => "I1F31",
            Q15 => "I1F15",
        }
    }

    /// `law` as a value of Rust.
    pub(crate) fn law(self, law: Law) -> String {
        match self {
            _ if law.has_handle() => "law".into(),
            F32 | Fast => law.rust.into(),
            Q31 => format!("Fixed({})", law.rust),
            Q15 => format!("Fixed16({})", law.rust),
        }
    }

    /// C's type; `cos_power`'s density is wider than the others'.
    pub(crate) fn c(self, role: Role, law: Law) -> String {
        if role == Role::Pair {
            return format!("coslobe_cos_sin_{}", self.base());
        }
        let (q31, q15) = match role {
            Role::Component => ("coslobe_q31", "coslobe_q15"),
            Role::Probability => ("coslobe_probability_q32", "coslobe_probability_q16"),
            Role::Angle => ("coslobe_turn_q32", "coslobe_turn_q16"),
            Role::Density if law.has_handle() => ("coslobe_density_q16_16", ""),
            Role::Density => ("coslobe_density_q32", "coslobe_density_q16"),
            Role::Weight => ("coslobe_weight_q16_16", "coslobe_weight_q16_16"),
            Role::Exponent => ("coslobe_exponent_q16_16", ""),
            Role::Length | Role::Pair => ("int32_t", "int16_t"),
        };
        match self {
            F32 | Fast => "float",
            Q31 => q31,
            Q15 => q15,
        }
        .into()
    }

    /// The type that Rust sees in its place.
    pub(crate) fn rust(self, role: Role) -> String {
        let signed = matches!(role, Role::Component | Role::Angle | Role::Length);
        match (role, self) {
            (Role::Pair, _) => return format!("Pair<{}>", self.rust(Role::Component)),
            (_, F32 | Fast) => "f32",
            (Role::Weight, _) => "u32",
            (_, Q31) if signed => "i32",
            (_, Q31) => "u32",
            (_, Q15) if signed => "i16",
            (_, Q15) => "u16",
        }
        .into()
    }

    /// What the library calls its laws' inside of, or its numbers'; `None` of `f32`.
    pub(crate) fn wrapper(self) -> Option<&'static str> {
        match self {
            F32 => None,
            Fast => Some("Fast"),
            Q31 => Some("Fixed"),
            Q15 => Some("Fixed16"),
        }
    }

    /// What makes the library's number of it, called with one argument; `None` where it is one.
    pub(crate) fn constructor(self, role: Role) -> Option<&'static str> {
        Some(match (self, role) {
            (_, Role::Pair) => "pair",
            (F32, _) => return None,
            (Fast, _) => return self.wrapper(),
            (Q31, Role::Component) => "I1F31::from_bits",
            (Q31, Role::Angle) => "I0F32::from_bits",
            (Q31, Role::Length) => "I32F0::from_bits",
            (Q31, Role::Exponent) => "U16F16::from_bits",
            (Q31, _) => "U0F32::from_bits",
            (Q15, Role::Component) => "I1F15::from_bits",
            (Q15, Role::Angle) => "I0F16::from_bits",
            (Q15, Role::Length) => "I16F0::from_bits",
            (Q15, _) => "U0F16::from_bits",
        })
    }

    /// The library's number of `x`.
    pub(crate) fn value(self, role: Role, x: &str) -> String {
        match self.constructor(role) {
            Some(constructor) => format!("{constructor}({x})"),
            None => x.into(),
        }
    }

    /// C's number of the library's `x`.
    pub(crate) fn get(self, x: &str) -> String {
        match self {
            F32 => x.into(),
            Fast => format!("{x}.0"),
            Q31 | Q15 => format!("{x}.to_bits()"),
        }
    }

    /// `call`, which gives an array, as C's numbers.
    pub(crate) fn get_each(self, call: &str) -> String {
        match self {
            F32 => call.into(),
            Fast => format!("{call}.map(|x: Fast<f32>| x.0)"),
            Q31 | Q15 => format!("{call}.map(|x| x.to_bits())"),
        }
    }
}
