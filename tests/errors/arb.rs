//! Every operation, and the references of the sweeps, against Arb's tables of proven values.

use kit::accuracy::bounds::allowed;
use kit::accuracy::double::Double;
use kit::accuracy::format::{Format, error_in_ulps};
use kit::accuracy::inverse::{angle, warp};
use kit::accuracy::reference::{self, Direction, Id};
use kit::accuracy::subject::Subject;
use kit::accuracy::wide::Wide;

/// One row of the committed tables.
struct Row {
    law: Id,
    operation: &'static str,
    argument: f64,
    value: Double,
}

fn rows(table: &'static str) -> Vec<Row> {
    let number = |s: &str| f64::from_bits(u64::from_str_radix(s, 16).expect("hex bits"));
    let law = |name: &str| Id::parse(name).expect("a law");
    table
        .lines()
        .filter(|l| !l.starts_with('#'))
        .map(|l| {
            let cells: Vec<_> = l.split(',').collect();
            let lo = Double::from(number(cells[4]));
            Row {
                law: law(cells[0]),
                operation: cells[1],
                argument: number(cells[2]),
                value: Double::from(number(cells[3])) + lo,
            }
        })
        .collect()
}

fn arb() -> Vec<Row> {
    let mut all = rows(include_str!("../reference/angles.csv"));
    all.extend(rows(include_str!("../reference/tails.csv")));
    assert!(all.len() > 7000);
    all
}

fn against_arb<T: Format>(want: impl Fn(&Row) -> T::Wide) {
    let mut checked = 0;
    for row in arb() {
        let x = T::of(row.argument);
        if x.wide() != row.argument {
            continue; // the argument is not a number of this format
        }
        let subject = Subject::<T>::of::<T>(row.law);
        let error = error_in_ulps(subject.call(row.operation, x), want(&row));
        let limit = allowed(subject.tier, row.law.name(), row.operation).expect("a bound");
        assert!(
            error <= limit,
            "{} {:?} {} at {:e}: {error} ulp, {limit} allowed",
            subject.tier,
            row.law,
            row.operation,
            row.argument
        );
        checked += 1;
    }
    assert!(checked > 2000, "{checked} rows");
}

#[test]
fn f64_against_arb() {
    against_arb::<f64>(|row| row.value);
}

#[test]
fn f32_against_arb() {
    against_arb::<f32>(|row| row.value.hi);
}

/// The wider arithmetic that judges the sweeps is itself judged by Arb.
fn reference_agrees<W: Wide>(judged: impl Fn(f64) -> bool) {
    for row in arb().iter().filter(|row| judged(row.argument)) {
        let (law, x) = (row.law, row.argument);
        let side = || {
            warp::<W>(
                law,
                x,
                row.operation.starts_with("warp_sf") || row.operation == "isf",
            )
        };
        let at = || Direction::<W>::at_angle(x);
        let got = match row.operation {
            "pdf" => reference::pdf(law, &at()),
            "ln_pdf" => reference::ln_pdf(law, &at()),
            "pdf_solid_angle" => reference::density(law, &at()),
            // The tables hold planar tails at +θ, the reference at −θ.
            "cdf" if law.planar() => reference::tails(law, &at()).1,
            "sf" if law.planar() => reference::tails(law, &at()).0,
            "cdf" => reference::tails(law, &at()).0,
            "sf" => reference::tails(law, &at()).1,
            "warp: cos" | "warp_sf: cos" => side().0,
            "warp: sin" | "warp_sf: sin" => side().1,
            _ => {
                // As the tables have it: from the tail of the lower side at −θ for a planar law.
                angle(law, x, side())
            }
        };
        let (near, want) = (got.near(), row.value.hi);
        // Below 1e-270 the low word of a double-double starts to underflow.
        if want.abs() < 1e-270 || (x < 1e-270 && x > 0.0) {
            assert!(
                (near - want).abs() <= 1e-14f64.max(W::EPS) * want.abs() + 1e-323,
                "{law:?} {} at {x:e}",
                row.operation
            );
            continue;
        }
        let error = (got - W::parts(want, row.value.lo)).near().abs() / want.abs();
        let scale = if want == 0.0 { 0.0 } else { error };
        assert!(
            scale < W::EPS,
            "{law:?} {} at {x:e}: off by {error:e}",
            row.operation
        );
    }
}

#[test]
fn double_double_reference_agrees_with_arb() {
    reference_agrees::<Double>(|_| true);
}

#[test]
fn f64_reference_agrees_with_arb() {
    // It judges f32 alone, so only at numbers of that format.
    reference_agrees::<f64>(|x| f64::from(x as f32) == x);
}
