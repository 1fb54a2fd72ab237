//! The harness: every test of one claim, on samples of anything that can be drawn.

use super::claim::{Claim, Direction};
use super::mean::Mean;
use super::report::Report;
use super::{chi2, ks, words};
use coslobe::rand_core::Rng;
use statrs::distribution::{DiscreteCDF, Poisson};
use std::f64::consts::TAU;

/// Cells of equal probability in θ, times as many in azimuth for spatial laws.
const SIDE: usize = 32;
/// Deepest octave of a tail that is counted apart.
const OCTAVES: usize = 160;
/// Below this tail equal samples are counted.
const TIE_TAIL: f64 = 1.0 / 256.0;
/// Cells of a conditioned tail: as many as `f32` has values below 2⁻⁶⁰.
const TAIL_CELLS: usize = 16;

/// Runs all tests on `n` samples.
pub fn examine(claim: &Claim, n: usize, mut draw: impl FnMut() -> Direction) -> Report {
    let mut report = Report::new(format!("{} n={n:e}", claim.name));
    let m = claim.moments;
    let expected = [
        ("mean cos", m.mean_cos),
        ("var cos", m.var_cos),
        ("mean theta", m.mean_theta),
        ("var theta", m.var_theta),
        ("entropy", m.entropy),
        ("mean x", 0.0),
        ("mean z", 0.0),
    ];
    let mut means = expected.map(|(name, value)| (name, Mean::of(value)));
    let mut grid = vec![0; SIDE * SIDE];
    let mut octaves = [[0; OCTAVES]; 2];
    let (mut us, mut turns, mut deep) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..n {
        let direction = draw();
        let Some((cos, sin)) = polar(claim, direction, &mut report) else {
            continue;
        };
        let (p, is_upper) = claim.tail(cos, sin);
        let u = if is_upper { 1.0 - p } else { p };
        let [x, _, z] = direction;
        let turn = (z.atan2(x) / TAU).rem_euclid(1.0);
        octaves[usize::from(is_upper)][octave(p)] += 1;
        if claim.planar {
            grid[cell(u, SIDE * SIDE)] += 1;
        } else {
            grid[cell(u, SIDE) * SIDE + cell(turn, SIDE)] += 1;
            turns.push(turn);
        }
        us.push(u);
        if p < TIE_TAIL && cos < sin.abs() {
            deep.push((cos.to_bits(), is_upper));
        }
        let theta = sin.atan2(cos);
        let (dc, dt) = (cos - m.mean_cos, theta - m.mean_theta);
        let values = [cos, dc * dc, theta, dt * dt, claim.surprise(cos, sin), x, z];
        // What a value may be off by: the direction's error, at most, times its derivative.
        let (off_cos, off_theta) = (claim.error * cos, claim.error * (2.0 * sin * cos).abs());
        let slacks = [
            off_cos,
            off_cos * (2.0 * dc.abs() + claim.error),
            off_theta,
            off_theta * (2.0 * dt.abs() + claim.error),
            claim.slack(cos, sin),
            0.0,
            0.0,
        ];
        for (((_, mean), (value, slack)), (_, of)) in means
            .iter_mut()
            .zip(values.into_iter().zip(slacks))
            .zip(expected)
        {
            mean.add(value, slack + claim.epsilon * f64::abs(of));
        }
    }
    report.add("cells", chi2::uniform(&grid));
    report.add("tail cells", tail_cells(&octaves));
    report.add("KS theta", ks::uniform(&mut us));
    if !claim.planar {
        report.add("KS azimuth", ks::uniform(&mut turns));
    }
    for (test, mean) in &means {
        report.add(test, mean.p_value());
    }
    report.add("ties", ties(claim, deep));
    report
}

/// The tail below 2^−`depth` alone, through a generator whose words `shape` sends there.
pub fn examine_tail(
    claim: &Claim,
    depth: u32,
    n: usize,
    shape: impl Fn(u32, u64) -> u64 + Copy,
    draw: impl Fn(&mut dyn Rng) -> Direction,
) -> Report {
    let mut report = Report::new(format!("{} tail 2^-{depth} n={n:e}", claim.name));
    let mut cells = [[0; TAIL_CELLS]; 2];
    let mut rng = words::pcg(&format!("{} {depth}", claim.name));
    for _ in 0..n {
        let direction = draw(&mut words::shaped(&mut rng, shape));
        let Some((cos, sin)) = polar(claim, direction, &mut report) else {
            continue;
        };
        let (p, is_upper) = claim.tail(cos, sin);
        let share = p * 2f64.powi(depth as i32);
        // Rounding of the direction to `f32` moves p by 1e-5 at most.
        if share > 1.001 + claim.slack(cos, sin) {
            report.fatal(format!("p = {p:e} lies outside the tail"));
        }
        cells[usize::from(is_upper)][cell(share, TAIL_CELLS)] += 1;
    }
    report.add("side", chi2::uniform(&cells.map(|side| side.iter().sum())));
    // Side by side, so that a subject with one tail alone is judged by its shape too.
    report.add("lower cells", chi2::uniform(&cells[0]));
    report.add("upper cells", chi2::uniform(&cells[1]));
    report
}

/// (cos θ, sin θ) of a unit vector inside the support; anything else is fatal.
fn polar(claim: &Claim, [x, y, z]: Direction, report: &mut Report) -> Option<(f64, f64)> {
    let sin = if claim.planar { x } else { x.hypot(z) };
    let off = (y.hypot(sin) - 1.0).abs();
    // With what computing the norm may add.
    if off > claim.length + f64::EPSILON {
        report.fatal(format!("[{x:e}, {y:e}, {z:e}] is {off:e} off unit length"));
    }
    // Written so that NaN fails.
    if y > 0.0 && off < claim.length.max(1e-6) {
        return Some((y, sin));
    }
    report.fatal(format!("[{x:e}, {y:e}, {z:e}] has no density"));
    None
}

fn cell(u: f64, cells: usize) -> usize {
    ((u * cells as f64) as usize).min(cells - 1)
}

/// n ≥ 1 with p from 2^−(n+1) to 2^−n.
fn octave(p: f64) -> usize {
    ((-p.log2()) as usize).clamp(1, OCTAVES - 1)
}

/// χ² over octaves of both tails: as fine towards the ends as the number of samples allows.
fn tail_cells(octaves: &[[u64; OCTAVES]; 2]) -> f64 {
    let n = octaves.iter().flatten().sum::<u64>() as f64;
    chi2::p_value(octaves.iter().flat_map(|side| {
        let cells = side.iter().enumerate().skip(1);
        cells.map(|(i, &observed)| (observed, n * 0.5f64.powi(i as i32 + 1)))
    }))
}

/// Equal cosines in the tail: a sampler on a grid repeats itself long before its gaps show.
///
/// Two samples fall on one of the type's cosines, ε apart, with probability ∫ f(c)² c ε dc ≤ (k+1)
/// ε/2; the uniform's own rounding adds ε/2 at most.
fn ties(claim: &Claim, mut deep: Vec<(u64, bool)>) -> f64 {
    deep.sort_unstable();
    let ties = deep.windows(2).filter(|pair| pair[0] == pair[1]).count() as u64;
    let pairs = 0.5 * (deep.len() as f64).powi(2);
    let expected = pairs * (claim.k + 2.0) * 0.5 * claim.grid;
    match ties.checked_sub(1) {
        Some(fewer) => Poisson::new(expected).map_or(f64::NAN, |law| law.sf(fewer)),
        None => 1.0,
    }
}
