//! The limits of time, and what is reached.

use crate::catalog;
use crate::contender::{DIRECTION, EXPONENT, PARTS, SAMPLE, vectors, whole};
use crate::mitsuba::{self, Mitsuba};
use crate::row::{self, Row, ours, quickest};
use crate::time::times;
use coslobe::batch::width::Width;
use kit::Id;
use kit::promises_ulps;
use std::error::Error;
use std::fmt::Write;
use std::path::Path;

/// A cost as a multiple of another in the same run, and the most that it may be.
struct Limit {
    /// Law, operation, type and vectors.
    what: [String; 3],
    most: f64,
    against: String,
    reached: Option<f64>,
    /// What of it a part alone takes.
    part: Option<f64>,
}

impl Limit {
    /// Of a call in time, one at a time or in vectors.
    fn of(
        rows: &[Row],
        call: [&str; 3],
        vectors: Option<&str>,
        most: f64,
        against: Option<&Row>,
    ) -> Limit {
        let own = ours(rows, call, vectors);
        let mut what = call.map(str::to_owned);
        what[2] = format!("`{}`", what[2]);
        what[2].extend(vectors.iter().flat_map(|v| [", ", v]));
        Limit {
            what,
            most,
            against: against.map_or(String::new(), |r| match r.ours {
                true => format!("{} in `{}`", r.call(), r.name),
                false => r.name.clone(),
            }),
            reached: ratio(own, against),
            part: None,
        }
    }

    fn verdict(&self) -> &'static str {
        match self.reached {
            Some(ratio) if ratio <= self.most => "reached",
            Some(_) => "**missed**",
            None => "not measured",
        }
    }
}

fn ratio(a: Option<&Row>, b: Option<&Row>) -> Option<f64> {
    a.zip(b).map(|(a, b)| a.time / b.time)
}

/// What a call of the coarse type cannot be without: of a draw its words and azimuth, of a loop
/// over pairs its roots and their stores.
fn part<'a>(
    rows: &'a [Row],
    law: &str,
    coarse: &str,
    operation: &str,
    width: Option<&str>,
) -> Option<&'a Row> {
    if operation == SAMPLE {
        // The disk's are as many as Lambert's.
        let law = if law == "Disk" { "Lambert" } else { law };
        return ours(rows, [law, PARTS, coarse], None);
    }
    let width = width.unwrap_or(vectors(Width::Compiled));
    ours(rows, [law, "warp_slice", coarse], Some(width))
}

/// Vectors of slices.
const WIDTHS: [&str; 2] = ["AVX2", "AVX-512"];

fn all(rows: &[Row], mitsuba: Option<&Mitsuba>) -> Vec<Limit> {
    let lobe = &*Id::CosPower(EXPONENT).to_string();
    let mut all = Vec::new();
    let draws = [
        ("Lambert", 0.95),
        ("Ball", 0.8),
        ("SphereShell", 1.0),
        ("CircleArc", 1.0),
        ("CircleShell", 0.6),
        ("Disk", 1.5),
        (lobe, 1.6),
    ];
    // One at a time: a direction drawn, and of an array of pairs.
    let pairs = [
        ("Lambert", 0.65),
        ("Ball", 0.65),
        ("SphereShell", 0.65),
        (lobe, 0.9),
    ];
    for (operation, limits) in [(SAMPLE, &draws[..]), (DIRECTION, &pairs)] {
        for &(law, most) in limits {
            for (name, most) in [("f32", most), ("f64", 1.0)] {
                let peer = quickest(rows, law, operation, Some(name));
                all.push(Limit::of(rows, [law, operation, name], None, most, peer));
            }
        }
    }
    // Slices.
    let slice = "warp_direction_slice";
    for (law, name, most) in [
        ("Lambert", "polar form, std f32", [0.17, 0.10]),
        ("Ball", "cos³ by √√u, std f32", [0.2, 0.12]),
        ("SphereShell", "cos² by cbrt, std f32", [0.25, 0.25]),
        (lobe, "cosⁿ by powf, std f32", [0.35, 0.35]),
    ] {
        let peer = row::peer(rows, law, DIRECTION, name);
        for (width, most) in WIDTHS.into_iter().zip(most) {
            all.push(Limit::of(
                rows,
                [law, slice, "f32"],
                Some(width),
                most,
                peer,
            ));
        }
    }
    for (law, operation, most, against) in [
        (
            "Disk",
            "warp_slice",
            0.25,
            ours(rows, ["Disk", "warp", "f32"], None),
        ),
        (
            "Lambert",
            "sample_slice",
            0.6,
            row::peer(rows, "Lambert", SAMPLE, SPHERE),
        ),
        (
            "Lambert",
            "sample_from_bits_slice",
            0.2,
            row::peer(rows, "Lambert", SAMPLE, SPHERE),
        ),
    ] {
        for width in WIDTHS {
            all.push(Limit::of(
                rows,
                [law, operation, "f32"],
                Some(width),
                most,
                against,
            ));
        }
    }
    // The coarse type against f32.
    let coarse = rows.iter().find(|r| r.ours && !promises_ulps(&r.name));
    let coarse = coarse.map_or("", |r| &r.name);
    let mut fast = |law, operation, width| {
        let plain = ours(rows, [law, operation, "f32"], width);
        all.push(Limit {
            part: ratio(part(rows, law, coarse, operation, width), plain),
            ..Limit::of(rows, [law, operation, coarse], width, 0.8, plain)
        });
    };
    draws.iter().for_each(|(law, _)| fast(law, SAMPLE, None));
    for (law, _) in pairs {
        fast(law, DIRECTION, None);
        WIDTHS
            .iter()
            .for_each(|width| fast(law, slice, Some(width)));
    }
    for (what, most, reached) in [
        ("time", 0.8, mitsuba.map(|m| m.time)),
        ("error of a component", 1.0, mitsuba.map(|m| m.component)),
        ("relative error of cos θ", 1.0, mitsuba.map(|m| m.cos)),
    ] {
        all.push(Limit {
            what: ["Lambert", slice, &format!("`f32`, {what}")].map(str::to_owned),
            most,
            against: mitsuba.map_or("Mitsuba".to_owned(), |m| {
                format!("Mitsuba {} at the same width", m.version)
            }),
            reached,
            part: None,
        });
    }
    all
}

/// A point of the sphere plus the normal.
const SPHERE: &str = "UnitSphere + normal, rand_distr f32";

fn table(out: &mut String, limits: &[Limit]) -> std::fmt::Result {
    writeln!(
        out,
        "| law | operation | type | at most | is | a part alone | of | |\n|---|---|---|---|---|---|---|---|"
    )?;
    for limit in limits {
        let [law, operation, kind] = &limit.what;
        let [ratio, part] =
            [limit.reached, limit.part].map(|r| r.map_or("–".to_owned(), |r| format!("{r:.3}")));
        let (most, against, verdict) = (limit.most, &limit.against, limit.verdict());
        writeln!(
            out,
            "| {law} | {operation} | {kind} | {most} | {ratio} | {part} | {against} | {verdict} |"
        )?;
    }
    Ok(())
}

/// The page's part.
pub(crate) fn section(
    out: &mut String,
    rows: &[Row],
    mitsuba: Option<&Mitsuba>,
) -> std::fmt::Result {
    let limits = all(rows, mitsuba);
    let count = |verdict| limits.iter().filter(|l| l.verdict() == verdict).count();
    writeln!(
        out,
        "\n## Limits of time\n\n\
         Multiples of a time in the same run, and what they are not to exceed: {} of {} are reached. Against the\n\
         quickest peer of the study in the same format, or the one named; `cargo run --release -p accuracy_cost -- limits`\n\
         measures these alone. Mitsuba's by `tools/mitsuba_peer.py`. *A part alone*: what the coarse type takes of the same\n\
         time for what it cannot be without: of a draw its words and azimuth, of a loop over pairs its roots and their stores\n\
         (`warp_slice`).\n",
        count("reached"),
        limits.len()
    )?;
    table(out, &limits)
}

/// Measures times and prints the table.
pub(crate) fn run(folder: &Path, strict: bool) -> Result<(), Box<dyn Error>> {
    let mitsuba = mitsuba::read(folder)?;
    let mut list = catalog::all();
    let timed = [SAMPLE, DIRECTION, "warp"];
    list.retain(|c| timed.contains(&whole(c.operation)));
    let times = times(&mut list, || {});
    let (counts, own) = (vec![None; list.len()], vec![None; list.len()]);
    let rows = row::rows(&list, &counts, &times, &own, &[]);
    let limits = all(&rows, mitsuba.as_ref());
    let mut out = String::new();
    table(&mut out, &limits)?;
    print!("{out}");
    let open = limits.iter().filter(|l| l.verdict() != "reached").count();
    if strict && open > 0 {
        let of = limits.len();
        return Err(format!("{open} of {of} limits are missed or not measured").into());
    }
    Ok(())
}
