//! Loops that shall be vectors, by their instructions an element.

use crate::arrays;
use crate::contender::{Contender, vectors};
use coslobe::batch::width::Width;
use kit::Id;
use kit::study::count::{self, Missing, counts_of};
use std::error::Error;

/// The hidden subcommand that valgrind runs for functions of slices.
pub(crate) const SUBCOMMAND: &str = "count-slices";

fn counted() -> Vec<Contender> {
    let mut list = Vec::new();
    arrays::all(&mut list);
    list.retain(Contender::countable);
    list
}

/// What valgrind runs.
pub(crate) fn child() {
    let mut all = counted();
    let cells = all.iter_mut().map(|c| &mut c.cell);
    count::child(cells.map(|c| [&mut *c.run, &mut *c.empty]));
}

/// Fails where a loop takes more instructions an element than the vectors of its width do.
///
/// Bounds lie a seventh above what rustc 1.95 reaches; a loop that is none of vectors takes several
/// times as many.
pub(crate) fn run() -> Result<(), Box<dyn Error>> {
    let list = counted();
    let calls: Vec<_> = list.iter().map(|c| c.cell.calls).collect();
    let counted = match counts_of(SUBCOMMAND, &calls, || {}) {
        Ok(counted) => counted,
        Err(Missing::Skipped(reason)) => {
            println!("SKIPPED: instructions: {reason}");
            return Ok(());
        }
        Err(Missing::Failed(e)) => return Err(e.into()),
    };
    let mut lost = Vec::new();
    let mut bounds = VECTORS.to_vec();
    for (c, &n) in list.iter().zip(&counted) {
        let width = c.width.map_or("", vectors);
        let what = format!("{} {} {} {width}", c.law, c.operation, c.name);
        let bound = bounds
            .iter()
            .position(|(name, _)| *name == what)
            .map(|i| bounds.remove(i).1);
        println!("{what}: {n:.1}");
        if bound.is_some_and(|bound| n > bound) {
            lost.push(format!(
                "{what}: {n:.1} instructions an element; expected at most {bound:?}"
            ));
        }
    }
    lost.extend(no_vectors(&list, &counted));
    lost.extend(
        bounds
            .iter()
            .map(|(what, _)| format!("{what}: not counted")),
    );
    if lost.is_empty() {
        Ok(())
    } else {
        Err(lost.join("\n").into())
    }
}

/// AVX2 holds twice as many elements as SSE2: a loop that takes nearly as many instructions at both
/// is none of vectors.
fn no_vectors(list: &[Contender], counted: &[f64]) -> Vec<String> {
    let all = || list.iter().zip(counted);
    // A generator's words come one after the other; near the axis the plain types' ln cos θ is
    // `libm`'s log1p, which branches.
    let branches = |c: &Contender| {
        matches!(c.law, Id::Disk | Id::CircleShell) && c.operation == "ln_pdf_slice"
    };
    let vectors = |c: &Contender| c.operation != "sample_slice" && !branches(c);
    let wide = all().filter(|(c, _)| c.width == Some(Width::Avx2) && vectors(c));
    let pairs = wide.filter_map(|(c, &wide)| {
        let same = |n: &Contender| n.law == c.law && n.operation == c.operation && n.name == c.name;
        let narrow = all().find(|(n, _)| n.width == Some(Width::Compiled) && same(n));
        let ratio = wide / narrow?.1;
        (ratio > MOST_AT_TWICE_THE_WIDTH).then(|| {
            let Contender { law, operation, name, .. } = c;
            format!("{law} {operation} {name}: {ratio:.2} of SSE2's instructions at AVX2; expected at most {MOST_AT_TWICE_THE_WIDTH}")
        })
    });
    pairs.collect()
}

const MOST_AT_TWICE_THE_WIDTH: f64 = 0.65;

/// Loops and the most instructions an element that each may take: a seventh more than was counted,
/// and no more than it once was.
const VECTORS: &[(&str, f64)] = &[
    ("Lambert warp_direction_slice f32 SSE2", 30.2),
    ("Lambert warp_direction_slice f32 AVX2", 11.8),
    ("Lambert sample_from_bits_slice f32 SSE2", 37.8),
    ("Lambert sample_from_bits_slice f32 AVX2", 17.5),
    ("Ball warp_direction_slice f32 SSE2", 31.2),
    ("Ball warp_direction_slice f32 AVX2", 12.5),
    ("Ball sample_from_bits_slice f32 SSE2", 32.1),
    ("Ball sample_from_bits_slice f32 AVX2", 15.0),
    ("SphereShell warp_direction_slice f32 SSE2", 46.7),
    ("SphereShell warp_direction_slice f32 AVX2", 19.5),
    ("SphereShell sample_from_bits_slice f32 SSE2", 33.3),
    ("SphereShell sample_from_bits_slice f32 AVX2", 15.7),
    ("CosPower(20) warp_direction_slice f32 SSE2", 64.3),
    ("CosPower(20) warp_direction_slice f32 AVX2", 27.9),
    ("CosPower(20) sample_from_bits_slice f32 SSE2", 75.5),
    ("CosPower(20) sample_from_bits_slice f32 AVX2", 33.6),
    ("Disk warp_slice f32 SSE2", 60.6),
    ("Disk warp_slice f32 AVX2", 27.8),
];
