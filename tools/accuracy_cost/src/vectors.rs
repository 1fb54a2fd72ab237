//! Loops that shall be vectors, by their instructions an element.

use crate::contender::{Contender, DIRECTION, vectors};
use crate::{arrays, catalog};
use coslobe::batch::width::Width;
use coslobe::{Lambert, Spatial};
use kit::Id;
use kit::study::count::{self, Missing, counts_of};
use kit::study::inputs::Uniforms;
use std::error::Error;

/// The hidden subcommand that valgrind runs for functions of slices.
pub(crate) const SUBCOMMAND: &str = "count-slices";

fn counted() -> Vec<Contender> {
    let mut list = catalog::all();
    let is_loop = |c: &Contender| c.ours && (c.width.is_some() || c.operation == DIRECTION);
    list.retain(|c| is_loop(c) && c.countable());
    list.push(whole_pairs());
    list
}

/// As a caller writes it: a law by its name, and of each pair the array.
fn whole_pairs() -> Contender {
    Contender {
        name: "f32, whole".to_owned(),
        short: String::new(),
        ours: true,
        format: "f32",
        law: Id::Lambert,
        operation: DIRECTION,
        width: None,
        cell: arrays::over_arrays(|pairs: &[[f32; 2]], out| {
            for (out, pair) in out.iter_mut().zip(pairs) {
                *out = Lambert.warp_direction(*pair);
            }
        }),
        own: Uniforms::Grid,
        measure: None,
    }
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
        // A caller's loop over pairs is compiled like the rest.
        let width = vectors(c.width.unwrap_or(Width::Compiled));
        let what = format!("{} {} {} {width}", c.law, c.operation, c.name);
        let bound = bounds
            .iter()
            .position(|(name, _)| *name == what)
            .map(|i| bounds.remove(i).1);
        println!("{what}: {n:.1}");
        if let Some(most) = bound.filter(|&most| n > most) {
            lost.push(format!(
                "{what}: {n:.1} instructions an element; expected at most {most}"
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
    ("Lambert warp_direction f32 SSE2", 24.0),
    ("Lambert warp_direction f32, whole SSE2", 24.0),
    ("Lambert warp_direction_slice f32 SSE2", 26.3),
    ("Lambert warp_direction_slice f32 AVX2", 11.0),
    ("Lambert sample_from_bits_slice f32 SSE2", 37.8),
    ("Lambert sample_from_bits_slice f32 AVX2", 17.5),
    ("Ball warp_direction f32 SSE2", 25.7),
    ("Ball warp_direction_slice f32 SSE2", 29.3),
    ("Ball warp_direction_slice f32 AVX2", 11.7),
    ("Ball sample_from_bits_slice f32 SSE2", 31.2),
    ("Ball sample_from_bits_slice f32 AVX2", 15.0),
    ("SphereShell warp_direction f32 SSE2", 42.1),
    ("SphereShell warp_direction_slice f32 SSE2", 44.0),
    ("SphereShell warp_direction_slice f32 AVX2", 18.4),
    ("SphereShell sample_from_bits_slice f32 SSE2", 32.3),
    ("SphereShell sample_from_bits_slice f32 AVX2", 15.7),
    ("CosPower(20) warp_direction f32 SSE2", 61.1),
    ("CosPower(20) warp_direction_slice f32 SSE2", 61.9),
    ("CosPower(20) warp_direction_slice f32 AVX2", 26.9),
    ("CosPower(20) sample_from_bits_slice f32 SSE2", 75.5),
    ("CosPower(20) sample_from_bits_slice f32 AVX2", 32.9),
    ("Disk warp_slice f32 SSE2", 60.6),
    ("Disk warp_slice f32 AVX2", 27.8),
];
