//! The limits of χ², computed here and committed for devices that cannot.

use statrs::distribution::{ChiSquared, ContinuousCDF};
use std::fmt::Write;

const FREEDOMS: [u8; 8] = [7, 15, 32, 37, 39, 41, 43, 63];
const ALARMS: [f64; 2] = [1e-6, 1e-9];
/// Eight statistics on two sides, twice over: see `alarms::the_limits_hold_for_counts`.
pub(crate) const SHARE: f64 = 32.0;
const PATH: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/src/self_test/table.rs");

/// Where a monotone function crosses 0, between 0 and 1000.
fn root(rises: impl Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, 1000.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if rises(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    high
}

/// \[least, most\] of χ² at a probability for each side.
pub(crate) fn sides(freedom: u8, p: f64) -> [f64; 2] {
    let law = ChiSquared::new(freedom.into()).unwrap();
    // statrs' own inverse is of 1 − p, which has no digits left.
    [root(|x| law.cdf(x) > p), root(|x| law.sf(x) < p)]
}

fn table() -> String {
    let mut text = String::from(
        "//! Limits of χ², in tenths. Made by `cargo test --test self_test -- --ignored write_limits`.\n\n\
         /// Degrees of freedom, and the \\[least, most\\] believed for each alarm in its order.\n\
         #[rustfmt::skip]\npub(super) const TABLE: [(u8, [[u32; 2]; 2]); ",
    );
    writeln!(text, "{}] = [", FREEDOMS.len()).unwrap();
    for freedom in FREEDOMS {
        let limits = ALARMS.map(|alarm| {
            let [least, most] = sides(freedom, alarm / SHARE);
            [(10.0 * least).floor() as u32, (10.0 * most).ceil() as u32]
        });
        writeln!(text, "    ({freedom}, {limits:?}),").unwrap();
    }
    text + "];\n"
}

#[test]
fn committed_limits_are_those_of_chi_squared() {
    let committed = include_str!("../../src/self_test/table.rs");
    assert!(
        committed == table(),
        "src/self_test/table.rs is out of date: cargo test --test self_test -- --ignored write_limits"
    );
}

#[test]
#[ignore = "writes src/self_test/table.rs: cargo test --release --test self_test -- --ignored"]
fn write_limits() {
    std::fs::write(PATH, table()).unwrap();
}

/// Against mpmath's incomplete gamma function, bisected with 30 digits.
#[test]
fn limits_agree_with_a_peer() {
    for (freedom, alarm, least, most) in [
        (15, 1e-6, 0.821032161, 63.4995701),
        (15, 1e-9, 0.317350448, 80.2638852),
        (32, 1e-9, 3.4670897, 112.758405),
        (41, 1e-6, 9.39732245, 107.922348),
        (63, 1e-6, 20.3130804, 141.215903),
        (63, 1e-9, 15.0594918, 163.949372),
    ] {
        let sides = sides(freedom, alarm / 16.0);
        for (ours, theirs) in sides.into_iter().zip([least, most]) {
            assert!(
                (ours / theirs - 1.0f64).abs() < 1e-6,
                "{freedom} {alarm:e}: {ours} for {theirs}"
            );
        }
    }
}
