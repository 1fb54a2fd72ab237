//! False alarms: how often a perfect generator and sampler are refused.

use crate::generators::good;
use crate::limits::{SHARE, sides};
use coslobe::self_test::{self, Alarm, Report};
use coslobe::{CircleArc, Lambert};
use rayon::prelude::*;
use statrs::distribution::{DiscreteCDF, Poisson};

/// Verdicts of `seeds` runs at the fewest samples, where χ² is least exact.
pub(crate) fn reports(seeds: u64) -> Vec<Report> {
    let run = |seed| {
        let mut rng = good(seed);
        if seed % 4 == 0 {
            let mut test = self_test::planar::<f32, _>(CircleArc);
            test.run(&mut rng, self_test::FEWEST);
            test.verdict(Alarm::OneInMillion)
        } else {
            let mut test = self_test::spatial::<f32, _>(Lambert);
            test.run(&mut rng, self_test::FEWEST);
            test.verdict(Alarm::OneInMillion)
        }
    };
    let verdicts = (0..seeds).into_par_iter().map(run);
    verdicts
        .map(|verdict| verdict.expect("a false alarm"))
        .collect()
}

/// Scores beyond what χ² has with probability p on a side: \[below, above\], and how many there
/// were.
pub(crate) fn beyond(reports: &[Report], p: f64) -> ([u64; 2], usize) {
    let scores = reports.iter().flat_map(|r| {
        [
            r.bits,
            r.flips,
            r.azimuth,
            r.eighths,
            r.polar,
            r.polar_azimuth,
            r.polar_pairs,
            r.azimuth_pairs,
        ]
    });
    let mut limits = std::collections::HashMap::new();
    let (mut counts, mut n) = ([0; 2], 0);
    for score in scores.flatten() {
        let [least, most] = *limits
            .entry(score.freedom)
            .or_insert_with(|| sides(score.freedom, p));
        // Tenths rounded down: the value itself lies between these two.
        let value = f64::from(score.tenths) / 10.0 + 0.05;
        counts[0] += u64::from(value < least);
        counts[1] += u64::from(value > most);
        n += 1;
    }
    (counts, n)
}

/// No more of them than p says, on either side; and not far fewer, so that the statistic is one.
fn calibrated(seeds: u64, probabilities: &[f64]) {
    let reports = reports(seeds);
    for &p in probabilities {
        let (counts, n) = beyond(&reports, p);
        let law = Poisson::new(p * n as f64).unwrap();
        println!("p = {p:e}: {counts:?} of {n}, expected {}", p * n as f64);
        for count in counts {
            assert!(
                law.sf(count) > 1e-4 && law.cdf(count) > 1e-4,
                "p = {p:e}: {counts:?} of {n}"
            );
        }
    }
}

#[test]
fn scores_are_chi_squared() {
    calibrated(4000, &[0.1, 0.01]);
}

#[test]
#[ignore = "2·10⁵ seeds, a minute: cargo test --release --test self_test -- --ignored"]
fn scores_are_chi_squared_farther_out() {
    calibrated(200_000, &[0.1, 0.01, 1e-3, 1e-4]);
}

/// P(χ² of independent Poisson cells > `limit`), contributions rounded up to 1/200.
fn poisson_tail(expected: &[f64], limit: f64) -> f64 {
    const STEPS: f64 = 200.0;
    let most = (limit * STEPS) as usize;
    let mut law = vec![0.0; most + 1];
    let mut beyond = 0.0;
    law[0] = 1.0;
    for &e in expected {
        let cell = Poisson::new(e).unwrap();
        let mut next = vec![0.0; most + 1];
        let far = 12.0 * e.sqrt() + 60.0;
        let atoms = ((e - far).max(0.0) as u64)..=((e + far) as u64);
        for count in atoms {
            let p = statrs::distribution::Discrete::pmf(&cell, count);
            let part = ((count as f64 - e).powi(2) / e * STEPS).ceil() as usize;
            for (i, &q) in law.iter().enumerate() {
                match next.get_mut(i + part) {
                    Some(slot) => *slot += q * p,
                    None => beyond += q * p,
                }
            }
        }
        law = next;
    }
    beyond
}

/// χ² is a law for many counts; with 16 to 64 expected in a cell the true tail at the limits is
/// heavier. By how much, for Poisson cells against χ² of as many degrees: the shares have to bear
/// it.
#[test]
fn the_limits_hold_for_counts() {
    let share = 1e-9 / SHARE;
    let factor = |cells: &[f64]| {
        let [_, most] = sides(cells.len() as u8, share);
        poisson_tail(cells, most) / share
    };
    let n = f64::from(self_test::FEWEST);
    let mut polar = vec![n / 32.0; 30];
    for halving in [6.0, 7.0, 8.0, 8.0] {
        polar.extend([n * 0.5f64.powf(halving); 2]);
    }
    let upper = [
        factor(&polar),
        factor(&[n / 8.0; 8]),
        factor(&[n / 16.0; 16]),
        factor(&[n / 64.0; 64]),
        factor(&[n / 128.0; 64]),
        factor(&[n / 128.0; 64]),
        1.0,
        1.0,
    ];
    // Bits and flips are sums of 3 n coin flips each; the lower sides are lighter than their law.
    let total = upper.iter().sum::<f64>() + 8.0;
    println!("heavier by {upper:.2?}, of {SHARE} shares {total:.1}");
    assert!(total <= SHARE, "{upper:?}");
    // It would not do with half the samples.
    assert!(factor(&[n / 256.0; 64]) > 12.0);
}
