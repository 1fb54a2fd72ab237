//! `Lambert.warp_direction_slice` over a caller's numbers, for a comparison with another program's
//! time.

use coslobe::{Lambert, Spatial};
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// Passes over the arrays; the quickest counts.
const PASSES: usize = 30;

/// The file holds all of u, then all of v. Prints nanoseconds a direction and the width of the
/// vectors, and writes all x, all y and all z if asked to.
pub(crate) fn run(input: &Path, values: Option<&Path>) -> Result<(), String> {
    let explain = |path: &Path, e: std::io::Error| format!("{}: {e}", path.display());
    let bytes = fs::read(input).map_err(|e| explain(input, e))?;
    if bytes.is_empty() || bytes.len() % 8 != 0 {
        return Err(format!(
            "{}: {} bytes; expected one or more pairs of f32 of 4 bytes each",
            input.display(),
            bytes.len()
        ));
    }
    let numbers = bytes
        .chunks_exact(4)
        .map(|b| f32::from_ne_bytes([b[0], b[1], b[2], b[3]]));
    let numbers: Vec<f32> = numbers.collect();
    let (u, v) = numbers.split_at(numbers.len() / 2);
    let mut out = [(); 3].map(|()| vec![0.0f32; u.len()]);
    let mut best = f64::INFINITY;
    for _ in 0..PASSES {
        let start = Instant::now();
        let slices = out.each_mut().map(|x| &mut x[..]);
        let done = Lambert.warp_direction_slice(black_box([u, v]), slices);
        best = best.min(start.elapsed().as_secs_f64());
        done.map_err(|e| e.to_string())?;
        black_box(&mut out);
    }
    let width = coslobe::batch::width::widest();
    println!("{} {width:?}", best * 1e9 / u.len() as f64);
    if let Some(path) = values {
        let bytes: Vec<u8> = out.iter().flatten().flat_map(|x| x.to_ne_bytes()).collect();
        fs::write(path, bytes).map_err(|e| explain(path, e))?;
    }
    Ok(())
}
