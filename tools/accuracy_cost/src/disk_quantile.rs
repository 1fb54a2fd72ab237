//! `Disk.quantile` over a caller's numbers, for a comparison with another program's time.

use coslobe::{Disk, Law};
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// Passes over the array; the quickest counts.
const PASSES: usize = 5;

/// Prints nanoseconds an element, and writes (θ, cos θ) if asked to.
pub(crate) fn run(input: &Path, values: Option<&Path>) -> Result<(), String> {
    let explain = |path: &Path, e: std::io::Error| format!("{}: {e}", path.display());
    let bytes = fs::read(input).map_err(|e| explain(input, e))?;
    if bytes.is_empty() || bytes.len() % 8 != 0 {
        return Err(format!(
            "{}: {} bytes; expected one or more f64 of 8 bytes each",
            input.display(),
            bytes.len()
        ));
    }
    let p: Vec<f64> = bytes
        .chunks_exact(8)
        .map(|b| f64::from_ne_bytes([b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7]]))
        .collect();
    let mut theta = vec![0.0; p.len()];
    let mut best = f64::INFINITY;
    for _ in 0..PASSES {
        let start = Instant::now();
        for (theta, &p) in theta.iter_mut().zip(&p) {
            *theta = Disk.quantile(p);
        }
        best = best.min(start.elapsed().as_secs_f64());
        black_box(&theta);
    }
    output::say(best * 1e9 / p.len() as f64);
    if let Some(path) = values {
        let pairs = p.iter().zip(&theta);
        let bytes: Vec<u8> = pairs
            .flat_map(|(&p, &theta)| [theta, Disk.warp(p).cos])
            .flat_map(f64::to_ne_bytes)
            .collect();
        fs::write(path, bytes).map_err(|e| explain(path, e))?;
    }
    Ok(())
}
