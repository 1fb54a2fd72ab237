//! Functions of a number or a direction that give one.

use crate::Law;
use crate::function::{Function, handle, name};
use crate::number::Role::{Angle, Density, Pair, Probability, Weight};
use crate::number::{Number, Role};

/// Each with what it takes and gives.
const VALUES: [(&str, Role, Role); 13] = [
    ("pdf", Angle, Density),
    ("ln_pdf", Angle, Density),
    ("pdf_solid_angle", Angle, Density),
    ("cdf", Angle, Probability),
    ("sf", Angle, Probability),
    ("quantile", Probability, Angle),
    ("isf", Probability, Angle),
    ("warp", Probability, Pair),
    ("warp_sf", Probability, Pair),
    ("unwarp", Pair, Probability),
    ("unwarp_sf", Pair, Probability),
    ("density", Pair, Density),
    ("lambert_weight", Pair, Weight),
];

pub(crate) fn functions(number: Number, law: Law) -> impl Iterator<Item = Function> {
    let offered = move |op: &str| match op {
        "pdf_solid_angle" => law.size == 3,
        "ln_pdf" => !number.is_integer(),
        _ => true,
    };
    let offered = VALUES.into_iter().filter(move |(op, ..)| offered(op));
    offered.map(move |(op, takes, gives)| function(number, law, op, takes, gives))
}

/// In the name of a runner.
fn word(role: Role) -> &'static str {
    match role {
        Angle => "angle",
        Probability => "probability",
        Density => "density",
        Weight => "weight",
        _ => "pair",
    }
}

fn function(number: Number, law: Law, op: &str, takes: Role, gives: Role) -> Function {
    let argument = match takes {
        Angle => "theta",
        Pair => "at",
        _ => "p",
    };
    let (subject, x) = (number.law(law), number.value(takes, argument));
    let call = if number.is_integer() {
        format!("{subject}.{op}({x})")
    } else if op == "pdf_solid_angle" {
        format!("Spatial::{op}(&{subject}, {x})")
    } else {
        format!("Law::{op}(&{subject}, {x})")
    };
    let call = if gives == Pair {
        format!("plain({call})")
    } else {
        number.get(&call)
    };
    let body = if law.has_handle() {
        let missing = match gives {
            Pair => "NO_PAIR",
            _ if number.is_integer() => "0",
            _ => "f32::NAN",
        };
        format!("with(law, {missing}, |law| {call})")
    } else {
        call
    };
    Function {
        name: name(law, op, number),
        arguments: vec![[
            format!("{} {argument}", number.c(takes, law)),
            format!("{argument}: {}", number.rust(takes)),
        ]],
        result: [number.c(gives, law), number.rust(gives)],
        body,
        kind: format!("{}_of_{}_{}", word(gives), word(takes), number.base()),
        handle: handle(law, number),
    }
}
