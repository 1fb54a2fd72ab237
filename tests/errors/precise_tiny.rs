//! `Precise<f64>` against Arb's tables of proven values, above all where arguments, results or the
//! steps between them underflow.
#![allow(clippy::incompatible_msrv)] // the MSRV is the core's; tests run on newer toolchains

use coslobe::{CosPower, CosSin, Lambert, Law, Precise, Spatial};
use kit::catalogue::one_law;
use kit::{Id, LawVisitor, PlanarLaw, SpatialLaw};
use std::collections::BTreeMap;

type P = Precise<f64>;

/// Allowed ulps.
const BOUND: f64 = 0.5 + 1.0 / 1048576.0;

/// A row of a table: the f64 nearest to the true value, and the rest of it in ulps of that.
struct Row<'a> {
    law: &'a str,
    operation: &'a str,
    arguments: [P; 2],
    value: f64,
    rest: f64,
}

fn number(hex: &str) -> f64 {
    f64::from_bits(u64::from_str_radix(hex, 16).expect("hex bits"))
}

fn lines(table: &str) -> impl Iterator<Item = Vec<&str>> {
    table
        .lines()
        .filter(|l| !l.starts_with('#'))
        .map(|l| l.split(',').collect())
}

fn tiny() -> Vec<Row<'static>> {
    lines(include_str!("../reference/tiny.csv"))
        .map(|cells| Row {
            law: cells[0],
            operation: cells[1],
            arguments: [cells[2], cells[3]].map(|c| match c {
                "" => Precise(f64::NAN),
                hex => Precise(number(hex)),
            }),
            value: number(cells[4]),
            rest: cells[5].parse().expect("a number of ulps"),
        })
        .collect()
}

/// The tables that judge the plain formats, as far as their trailing words hold.
fn ordinary() -> Vec<Row<'static>> {
    let tables = [
        include_str!("../reference/angles.csv"),
        include_str!("../reference/tails.csv"),
    ];
    let rows = tables.into_iter().flat_map(lines).map(|cells| {
        let (value, lo) = (number(cells[3]), number(cells[4]));
        Row {
            law: cells[0],
            operation: cells[1],
            arguments: [Precise(number(cells[2])), Precise(f64::NAN)],
            value,
            rest: lo / ulp(value),
        }
    });
    rows.filter(|row| row.value.abs() > 1e-290).collect()
}

/// Distance of neighbours at |x|, finite x.
fn ulp(x: f64) -> f64 {
    let bits = x.abs().to_bits();
    f64::from_bits(bits + 1) - f64::from_bits(bits)
}

/// A law, and its density per steradian if it has one.
struct Subject {
    law: Box<dyn Law<P>>,
    solid: Option<Box<dyn Fn(P) -> P>>,
}

struct Found(Option<Subject>);

impl LawVisitor<P> for Found {
    fn planar<L: PlanarLaw<P>>(&mut self, _: Id, law: L) {
        self.0 = Some(Subject {
            law: Box::new(law),
            solid: None,
        });
    }
    fn spatial<L: SpatialLaw<P>>(&mut self, _: Id, law: L) {
        self.0 = Some(Subject {
            law: Box::new(law),
            solid: Some(Box::new(move |x| law.pdf_solid_angle(x))),
        });
    }
}

fn subject(name: &str) -> Subject {
    let mut found = Found(None);
    one_law(Id::parse(name).expect("a law"), &mut found);
    found.0.expect("a valid exponent")
}

fn call(row: &Row) -> f64 {
    let Subject { law, solid } = subject(row.law);
    let [x, y] = row.arguments;
    let at = CosSin { cos: x, sin: y };
    let got = match row.operation {
        "pdf" => law.pdf(x),
        "ln_pdf" => law.ln_pdf(x),
        "pdf_solid_angle" => solid.expect("a spatial law")(x),
        "cdf" => law.cdf(x),
        "sf" => law.sf(x),
        "warp: cos" => law.warp(x).cos,
        "warp: sin" => law.warp(x).sin,
        "warp_sf: cos" => law.warp_sf(x).cos,
        "warp_sf: sin" => law.warp_sf(x).sin,
        "quantile" => law.quantile(x),
        "isf" => law.isf(x),
        "density" => law.density(at),
        "unwarp" => law.unwarp(at),
        "unwarp_sf" => law.unwarp_sf(at),
        "lambert_weight" => law.lambert_weight(at),
        // At the horizon sin θ = 1, and the direction is the azimuth.
        "turn: cos" => Lambert.warp_direction([Precise(1.0), x])[0],
        "turn: sin" => Lambert.warp_direction([Precise(1.0), x])[2],
        "turn" => Lambert.unwarp_direction([y, Precise(0.0), x])[1],
        other => panic!("unknown operation {other}"),
    };
    got.0
}

fn error(row: &Row, got: f64) -> f64 {
    if got == row.value || row.value.is_infinite() {
        return if got == row.value {
            row.rest.abs()
        } else {
            f64::INFINITY
        };
    }
    let error = ((got - row.value) / ulp(row.value) - row.rest).abs();
    if error.is_nan() { f64::INFINITY } else { error }
}

/// The worst of each law and operation, with its arguments.
fn judge(rows: &[Row], call: impl Fn(&Row) -> f64) -> BTreeMap<(String, String), (f64, [u64; 2])> {
    let mut worst = BTreeMap::new();
    for row in rows {
        let e = error(row, call(row));
        let key = (row.operation.to_owned(), row.law.to_owned());
        let entry = worst.entry(key).or_insert((0.0, [0; 2]));
        if e >= entry.0 {
            *entry = (e, row.arguments.map(|x| x.0.to_bits()));
        }
    }
    worst
}

fn within_bound(rows: &[Row]) {
    let worst = judge(rows, call);
    let mut failed = 0;
    for ((operation, law), (e, [x, y])) in &worst {
        println!("{operation:16} {law:16} {e:.8} ulp at {x:016x} {y:016x}");
        failed += u32::from(*e > BOUND);
    }
    assert_eq!(failed, 0, "operations beyond {BOUND} ulp");
}

#[test]
fn where_numbers_underflow() {
    let rows = tiny();
    assert!(rows.len() > 9000, "{} rows", rows.len());
    within_bound(&rows);
}

#[test]
fn where_they_do_not() {
    let rows = ordinary();
    assert!(rows.len() > 6500, "{} rows", rows.len());
    within_bound(&rows);
}

/// sin²θ of a pair, which underflows, times an exponent that brings it back.
#[test]
fn a_lobe_as_narrow_as_numbers_allow() {
    let power = |n| 2f64.powi(n);
    let law = CosPower::new(Precise(power(880))).expect("an exponent");
    for sin in [1.0, 1.1, 1.3, 1.7] {
        let at = CosSin {
            cos: Precise(1.0),
            sin: Precise(sin * power(-530)),
        };
        // (k + 1) sin²θ/2: all other terms are too small to count.
        assert_eq!(law.unwarp(at).0, sin * sin * power(-181), "{sin}");
    }
}

/// A step of a single last place away from the truth is beyond the bound, wherever it is taken.
#[test]
fn a_planted_error_is_seen() {
    for row in tiny().iter().filter(|row| row.value.is_finite()) {
        let got = call(row);
        let spoiled = [got.next_up(), got.next_down()].map(|x| error(row, x));
        let worse = spoiled[0].max(spoiled[1]);
        assert!(worse > BOUND, "{} {}: {worse}", row.law, row.operation);
    }
}
