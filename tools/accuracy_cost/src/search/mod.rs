//! Searches for the inputs with the largest errors, and keeps them in a file.
//!
//! Judged by the references of `tests/kit` (double-double with an exponent of its own, and for f32
//! `f64`), which `tests/arb.rs` holds against Arb's tables.

mod candidates;
mod climb;

use crate::args::SearchArgs;
use climb::Search;
use kit::accuracy::bounds::allowed;
use kit::accuracy::found::{Found, from_json, to_json};
use kit::accuracy::reference::Id;
use kit::catalogue::every_number;
use kit::{Number, NumberVisitor};
use std::error::Error;
use std::fs;
use std::time::Duration;

pub(crate) fn run(args: &SearchArgs) -> Result<(), Box<dyn Error>> {
    let mut rows = match fs::read_to_string(&args.out) {
        Ok(text) => from_json(&text).map_err(|e| format!("{}: {e}", args.out.display()))?,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => Vec::new(),
        Err(e) => return Err(format!("{}: {e}", args.out.display()).into()),
    };
    let laws = Id::FIXED.map(Id::name).into_iter().chain(["CosPower"]);
    let laws: Vec<_> = laws
        .filter(|l| args.law.as_deref().is_none_or(|a| a == *l))
        .collect();
    if laws.is_empty() {
        return Err("--law: no such law; expected one as the crate names it, such as Ball".into());
    }
    for law in laws {
        let mut each = Each {
            args,
            law,
            rows: &mut rows,
            done: Ok(()),
        };
        every_number(&mut each);
        each.done?;
    }
    Ok(())
}

/// A law in each number type.
struct Each<'a> {
    args: &'a SearchArgs,
    law: &'a str,
    rows: &'a mut Vec<Found>,
    done: Result<(), Box<dyn Error>>,
}

impl NumberVisitor for Each<'_> {
    fn number<T: Number>(&mut self) {
        // Of 32 bits every input of the laws without an exponent is tried elsewhere.
        let searched = size_of::<T>() == 8 || self.law == "CosPower" || self.args.number.is_some();
        if searched && self.done.is_ok() {
            self.done = one::<T>(self.args, self.law, self.rows);
        }
    }
}

fn one<T: Number>(
    args: &SearchArgs,
    law: &str,
    rows: &mut Vec<Found>,
) -> Result<(), Box<dyn Error>> {
    if args.number.as_deref().is_some_and(|name| name != T::NAME) {
        return Ok(());
    }
    let mut search = Search::<T>::new(law, args.seed, rows);
    search.run(Duration::from_secs_f64(args.seconds), args.op.as_deref());
    let found = search.found();
    for f in &found {
        let cell = allowed(&f.tier, &f.law, &f.operation).unwrap_or(0.0);
        let mark = if f.error > cell { "  EXCEEDED" } else { "" };
        let exponent = f
            .exponent
            .as_deref()
            .map_or(String::new(), |k| format!(" k {k}"));
        println!(
            "{:13} {:12} {:16} {:8.4} of {cell} at {} {}{exponent}{mark}",
            f.tier, f.law, f.operation, f.error, f.input, f.bits
        );
    }
    rows.retain(|row| !found.iter().any(|f| f.key() == row.key()));
    rows.extend(found);
    rows.sort_by(|a, b| a.key().cmp(&b.key()));
    // Another search may have written meanwhile: whole, never half.
    let draft = args.out.with_extension("draft");
    fs::write(&draft, to_json(rows)?)?;
    fs::rename(&draft, &args.out)?;
    Ok(())
}
