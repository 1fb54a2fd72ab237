//! The limits of time and of instructions, and what is reached.

use crate::arrays::{self, DIRECTION, PAIRS, SAMPLE, SCALAR, WARP, name};
use crate::catalog::Counted;
use crate::contender::{Contender, EXPONENT};
use crate::time::times;
use coslobe::Fast;
use coslobe::batch::width::{Width, widest};
use kit::Id;
use kit::study::count::{Missing, counts_of};
use std::error::Error;

/// The hidden subcommand that valgrind runs for loops over arrays.
pub(crate) const SUBCOMMAND: &str = "count-arrays";

/// Contenders with what each takes.
struct Timed {
    list: Vec<Contender>,
    ns: Vec<f64>,
}

impl Timed {
    fn new(mut list: Vec<Contender>) -> Timed {
        let ns = times(&mut list, || {});
        Timed { list, ns }
    }

    fn each(&self) -> impl Iterator<Item = (&Contender, f64)> {
        self.list.iter().zip(self.ns.iter().copied())
    }

    fn ours(&self, law: Id, operation: &str, name: &str) -> Option<f64> {
        let same = |c: &Contender| c.ours && c.law == law && c.operation == operation;
        let found = self.each().find(|(c, _)| same(c) && c.name == name);
        found.map(|(_, ns)| ns)
    }

    /// The quickest peer.
    fn peer(&self, law: Id, operation: &str, format: &str) -> Option<(&str, f64)> {
        let peers = self.each().filter(|(c, _)| !c.ours && c.law == law);
        let peers = peers.filter(|(c, _)| c.operation == operation && c.format == format);
        let quickest = peers.min_by(|a, b| a.1.total_cmp(&b.1));
        quickest.map(|(c, ns)| (&*c.name, ns))
    }
}

/// Prints a line: what, the limit, what is reached.
fn line(law: Id, what: &str, limit: f64, ours: Option<f64>, peer: Option<(&str, f64)>) {
    let (Some(ours), Some((peer, theirs))) = (ours, peer) else {
        println!("SKIPPED: {law} {what}: not on this processor");
        return;
    };
    let ratio = ours / theirs;
    let verdict = if ratio <= limit { "reached" } else { "MISSED" };
    let law = law.to_string();
    println!(
        "| {law} | {what} | {limit} | {ratio:.3} | {peer} | {ours:.2} | {theirs:.2} | {verdict} |"
    );
}

pub(crate) fn run() -> Result<(), Box<dyn Error>> {
    let lobe = Id::CosPower(EXPONENT);
    println!("| law | what | limit | ratio | quickest peer | ns | its ns | |");
    println!("|---|---|---|---|---|---|---|---|");
    let draws = Counted::new().list;
    let draws = draws.into_iter().filter(|c| c.operation == SAMPLE);
    let draws = Timed::new(draws.collect());
    let single = [
        (Id::Lambert, 0.95),
        (Id::Ball, 0.8),
        (Id::SphereShell, 1.0),
        (Id::CircleArc, 1.0),
        (Id::CircleShell, 0.6),
        (Id::Disk, 1.5),
        (lobe, 1.6),
    ];
    for (law, limit) in single {
        let ours = draws.ours(law, SAMPLE, "f32");
        line(
            law,
            "draw, f32",
            limit,
            ours,
            draws.peer(law, SAMPLE, "f32"),
        );
    }
    for (law, _) in single {
        let ours = draws.ours(law, SAMPLE, "f64");
        line(law, "draw, f64", 1.0, ours, draws.peer(law, SAMPLE, "f64"));
    }
    for (law, _) in single {
        let plain = draws.ours(law, SAMPLE, "f32").map(|ns| ("f32", ns));
        line(
            law,
            "draw, Fast<f32>",
            0.8,
            draws.ours(law, SAMPLE, "Fast<f32>"),
            plain,
        );
    }

    let loops = Timed::new(arrays::timed());
    let pairs = format!("f32 {PAIRS}");
    let widths = [Width::Avx2, Width::Avx512].map(|w| name::<f32>("slices", w));
    for (law, array, slices) in [
        (Id::Lambert, 0.65, [0.17, 0.10]),
        (Id::Ball, 0.65, [0.2, 0.12]),
        (Id::SphereShell, 0.65, [0.25, 0.25]),
        (lobe, 0.9, [0.35, 0.35]),
    ] {
        let peer = loops.peer(law, DIRECTION, "f32");
        line(law, &pairs, array, loops.ours(law, DIRECTION, &pairs), peer);
        for (what, limit) in widths.iter().zip(slices) {
            line(law, what, limit, loops.ours(law, DIRECTION, what), peer);
        }
    }
    let scalar = format!("f32 {SCALAR}");
    let one = loops.ours(Id::Disk, WARP, &scalar).map(|ns| (&*scalar, ns));
    for what in &widths {
        line(Id::Disk, what, 0.25, loops.ours(Id::Disk, WARP, what), one);
    }
    let peer = loops.peer(Id::Lambert, SAMPLE, "f32");
    for (what, limit) in [("sample_slice", 0.6), ("sample_from_bits_slice", 0.2)] {
        let what = name::<f32>(what, widest());
        line(
            Id::Lambert,
            &what,
            limit,
            loops.ours(Id::Lambert, SAMPLE, &what),
            peer,
        );
    }
    for law in [Id::Lambert, Id::Ball, Id::SphereShell, lobe] {
        let plain = name::<f32>("slices", widest());
        let peer = loops.ours(law, DIRECTION, &plain).map(|ns| (&*plain, ns));
        let fast = name::<Fast<f32>>("slices", widest());
        line(law, &fast, 0.8, loops.ours(law, DIRECTION, &fast), peer);
    }
    Ok(())
}

/// Fails where a loop takes more instructions an element than the vectors of its width do.
///
/// Bounds lie a quarter above what rustc 1.95 reaches; a loop that is none of vectors takes several times as many.
pub(crate) fn vectors() -> Result<(), Box<dyn Error>> {
    let list = arrays::counted();
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
    for (c, n) in list.iter().zip(counted) {
        let what = format!("{} {} {}", c.law, c.operation, c.name);
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

/// Loops and the most instructions an element that each may take: a seventh more than was counted.
const VECTORS: &[(&str, f64)] = &[
    ("Lambert warp_direction f32 slices, Compiled", 30.2),
    ("Lambert warp_direction f32 slices, Avx2", 15.2),
    ("Lambert sample f32 sample_from_bits_slice, Compiled", 48.6),
    ("Lambert sample f32 sample_from_bits_slice, Avx2", 24.2),
    ("Ball warp_direction f32 slices, Compiled", 31.4),
    ("Ball warp_direction f32 slices, Avx2", 15.3),
    ("Ball sample f32 sample_from_bits_slice, Compiled", 50.3),
    ("Ball sample f32 sample_from_bits_slice, Avx2", 24.2),
    ("SphereShell warp_direction f32 slices, Compiled", 46.7),
    ("SphereShell warp_direction f32 slices, Avx2", 21.9),
    (
        "SphereShell sample f32 sample_from_bits_slice, Compiled",
        45.6,
    ),
    ("SphereShell sample f32 sample_from_bits_slice, Avx2", 21.5),
    ("CosPower(20) warp_direction f32 slices, Compiled", 73.8),
    ("CosPower(20) warp_direction f32 slices, Avx2", 31.9),
    (
        "CosPower(20) sample f32 sample_from_bits_slice, Compiled",
        92.8,
    ),
    ("CosPower(20) sample f32 sample_from_bits_slice, Avx2", 40.3),
    ("Disk warp f32 slices, Compiled", 61.3),
    ("Disk warp f32 slices, Avx2", 29.1),
];
