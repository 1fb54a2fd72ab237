//! Every operation against true values: Arb's tables, and sweeps against wider arithmetic.

mod accuracy;

use accuracy::bounds::allowed;
use accuracy::double::Double;
use accuracy::format::{Format, Subject, error_in_ulps};
use accuracy::inputs::{EXPONENTS, sample};
use accuracy::measure::{OPERATIONS, Tally, at_angle, at_tail, sweep};
use accuracy::monotone;
use accuracy::reference::{self, Direction, Id};
use accuracy::wide::Wide;
use coslobe::{CosSin, Disk, Law, Moments, SphereShell, Tails};

fn report<T: Format>(subjects: &[Subject<T>], tally: &Tally) -> Vec<String> {
    let mut broken = Vec::new();
    for (s, row) in subjects.iter().zip(&tally.0) {
        for ((_, name), worst) in OPERATIONS.iter().zip(row) {
            if worst.tried == 0 {
                continue;
            }
            let limit = allowed(T::NAME, s.id, name).unwrap_or(0.0);
            if worst.ulps > limit {
                broken.push(format!(
                    "{} {:?} {name}: {:.3} ulp at {:#x}, {limit} allowed",
                    T::NAME,
                    s.id,
                    worst.ulps,
                    worst.input
                ));
            }
        }
    }
    broken
}

fn holds<T: Format>(subjects: &[Subject<T>], tally: &Tally) {
    let broken = report(subjects, tally);
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

fn powers() -> Vec<Id> {
    EXPONENTS.map(Id::CosPower).to_vec()
}

fn swept<T: Format>(ids: &[Id], stride: u64) {
    let subjects = Subject::<T>::all(ids);
    let angles = sweep(&subjects, T::TOP_ANGLE, stride, at_angle, |_| ());
    holds(
        &subjects,
        &angles.merge(sweep(&subjects, T::HALF_BITS, stride, at_tail, |_| ())),
    );
}

fn sampled<T: Format>(ids: &[Id], n: u64) {
    let subjects = Subject::<T>::all(ids);
    let angles = sample(&subjects, T::TOP_ANGLE, n, at_angle, |_| ());
    holds(
        &subjects,
        &angles.merge(sample(&subjects, T::HALF_BITS, n, at_tail, |_| ())),
    );
}

#[test]
fn f32_strided() {
    swept::<f32>(&Id::FIXED, 1009);
}

#[test]
#[ignore = "opt-in, an hour: cargo test --release --test error_bounds -- --ignored"]
fn f32_exhaustive() {
    swept::<f32>(&Id::FIXED, 1);
}

#[test]
fn f64_stratified() {
    sampled::<f64>(&Id::FIXED, 1_000_002);
}

#[test]
fn real_exponents() {
    sampled::<f32>(&powers(), 100_002);
    sampled::<f64>(&powers(), 60_000);
}

/// One row of the committed tables.
struct Row {
    law: Id,
    operation: &'static str,
    argument: f64,
    value: Double,
}

fn rows(table: &'static str) -> Vec<Row> {
    let number = |s: &str| f64::from_bits(u64::from_str_radix(s, 16).expect("hex bits"));
    let law = |name: &str| match name.strip_prefix("CosPower(") {
        Some(k) => Id::CosPower(k.trim_end_matches(')').parse().expect("an exponent")),
        None => *Id::FIXED.iter().find(|l| l.name() == name).expect("a law"),
    };
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
    let mut all = rows(include_str!("reference/angles.csv"));
    all.extend(rows(include_str!("reference/tails.csv")));
    assert!(all.len() > 7000);
    all
}

/// What the crate says for a row of the tables.
fn call<T: Format>(s: &Subject<T>, operation: &str, x: T) -> T {
    let law = &s.law;
    match operation {
        "pdf" => law.pdf(x),
        "ln_pdf" => law.ln_pdf(x),
        "pdf_solid_angle" => s.solid.as_ref().expect("a spatial law")(x),
        "cdf" => law.cdf(x),
        "sf" => law.sf(x),
        "warp: cos" => law.warp(x).cos,
        "warp: sin" => law.warp(x).sin,
        "warp_sf: cos" => law.warp_sf(x).cos,
        "warp_sf: sin" => law.warp_sf(x).sin,
        "quantile" => law.quantile(x),
        "isf" => law.isf(x),
        other => panic!("unknown operation {other}"),
    }
}

fn against_arb<T: Format>(want: impl Fn(&Row) -> T::Wide) {
    let mut checked = 0;
    for row in arb() {
        let x = T::round(row.argument);
        if x.wide() != row.argument {
            continue; // the argument is not a number of this format
        }
        let subject = Subject::<T>::new(row.law);
        let error = error_in_ulps(call(&subject, row.operation, x), want(&row));
        let limit = allowed(T::NAME, row.law, row.operation).expect("a bound");
        assert!(
            error <= limit,
            "{} {:?} {} at {:e}: {error} ulp, {limit} allowed",
            T::NAME,
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
            reference::warp::<W>(
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
                let (cos, sin) = side();
                W::angle(cos, sin)
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

/// A law with one operation spoiled: the tests above must notice each.
#[derive(Clone, Copy)]
enum Spoiled {
    /// cos θ of an `f32` angle against `f32`'s π/2: the digits beside the horizon are gone.
    NaiveCosine,
    /// The upper tail as 1 − u.
    OneMinus,
    /// Kepler's residual y − sin y by subtraction.
    NaiveResidual,
    /// Six last places off in one window in a thousand.
    Nudged,
}

impl<T: Format> Law<T> for Spoiled {
    fn pdf(&self, theta: T) -> T {
        match self {
            Spoiled::NaiveCosine => {
                let c = T::round(T::round(std::f64::consts::FRAC_PI_2).wide() - theta.wide())
                    .wide()
                    .sin();
                T::round(c * c * std::f64::consts::FRAC_2_PI)
            }
            Spoiled::Nudged if (1.0..1.001).contains(&theta.wide()) => {
                T::of_bits(Disk.pdf(theta).bits() + 6)
            }
            _ => Disk.pdf(theta),
        }
    }
    fn tails(&self, theta: T) -> Tails<T> {
        match self {
            Spoiled::OneMinus => Tails::from_lower(Law::<T>::cdf(&Disk, theta)),
            Spoiled::NaiveResidual => {
                let y = 2.0 * (std::f64::consts::FRAC_PI_2 - theta.wide().abs());
                Tails::from_upper(T::round((y - y.sin()) / std::f64::consts::TAU))
            }
            _ => Disk.tails(theta),
        }
    }
    fn ln_pdf(&self, theta: T) -> T {
        Disk.ln_pdf(theta)
    }
    fn density(&self, at: CosSin<T>) -> T {
        Disk.density(at)
    }
    fn warp_tails(&self, p: Tails<T>) -> CosSin<T> {
        Disk.warp_tails(p)
    }
    fn unwarp_tails(&self, at: CosSin<T>) -> Tails<T> {
        Disk.unwarp_tails(at)
    }
    fn lambert_weight(&self, at: CosSin<T>) -> T {
        Disk.lambert_weight(at)
    }
    fn moments(&self) -> Moments<T> {
        Disk.moments()
    }
}

fn rejects<T: Format>(spoiled: Spoiled, stride: u64) {
    let subjects = [Subject::<T> {
        id: Id::Disk,
        law: Box::new(spoiled),
        solid: None,
    }];
    let tally = sweep(&subjects, T::TOP_ANGLE, stride, at_angle, |_| ());
    assert!(!report(&subjects, &tally).is_empty());
}

#[test]
fn planted_errors_are_caught() {
    for spoiled in [
        Spoiled::NaiveCosine,
        Spoiled::OneMinus,
        Spoiled::NaiveResidual,
        Spoiled::Nudged,
    ] {
        rejects::<f32>(spoiled, 1009);
    }
    rejects::<f64>(Spoiled::OneMinus, 1 << 40);
    rejects::<f64>(Spoiled::NaiveResidual, 1 << 40);
}

/// A law under another's name is caught too: the sphere's shell is not the sphere's area.
#[test]
fn a_wrong_exponent_is_caught() {
    let subjects = [Subject::<f32> {
        id: Id::Lambert,
        law: Box::new(SphereShell),
        solid: None,
    }];
    let tally = sweep(&subjects, f32::HALF_BITS, 100_003, at_tail, |_| ());
    assert!(!report(&subjects, &tally).is_empty());
}

fn never_steps_back(find: impl Fn(Id) -> (u64, u64)) {
    for id in Id::FIXED {
        let (bad, first) = find(id);
        assert_eq!(
            bad, 0,
            "{id:?}: quantile or isf steps back or does not mirror from {first:#x}"
        );
    }
}

#[test]
fn quantiles_are_monotone_and_odd() {
    never_steps_back(|id| monotone::strided(&Subject::<f32>::new(id), 101));
    never_steps_back(|id| monotone::sampled(&Subject::<f64>::new(id), 1_000_000));
}

#[test]
#[ignore = "opt-in, minutes: cargo test --release --test error_bounds -- --ignored"]
fn f32_quantiles_are_monotone_everywhere() {
    never_steps_back(|id| monotone::strided(&Subject::<f32>::new(id), 1));
}
