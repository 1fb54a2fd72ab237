//! Searches for the inputs with the largest errors, and keeps them in a file.
//!
//! Judged by the references of `tests/kit` (double-double with an exponent of its own, and for f32
//! `f64`), which `tests/arb.rs` holds against Arb's tables.

mod candidates;
mod climb;

use crate::args::SearchArgs;
use climb::Search;
use coslobe::{Fast, Precise};
use kit::Number;
use kit::accuracy::bounds::allowed;
use kit::accuracy::found::{Found, from_json, to_json};
use kit::accuracy::reference::Id;
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
        one::<f64>(args, law, &mut rows)?;
        one::<Precise<f64>>(args, law, &mut rows)?;
        // Of f32 every input of the laws without an exponent is tried elsewhere.
        if law == "CosPower" || args.number.is_some() {
            one::<f32>(args, law, &mut rows)?;
            one::<Precise<f32>>(args, law, &mut rows)?;
            one::<Fast<f32>>(args, law, &mut rows)?;
        }
    }
    Ok(())
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
