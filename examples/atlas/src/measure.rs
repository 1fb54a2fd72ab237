//! Sampling: the mean of cos θ, the histogram of θ, and the words of randomness.

use crate::number::Number;
use crate::probe::Side;
use crate::random::{Counter, stream};
use crate::sweep::Sweep;
use indicatif::ProgressBar;
use rayon::prelude::*;
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Cells of the histogram.
pub(crate) const CELLS: usize = 45;
/// Samples of one generator; fixed, so that the thread count cannot matter.
const CHUNK: u64 = 1 << 15;

/// What was seen of a law in one number type.
pub(crate) struct Report {
    pub(crate) format: &'static str,
    pub(crate) mean_cos: f64,
    pub(crate) exact_mean: f64,
    /// (mean − exact) in standard errors.
    pub(crate) z: f64,
    /// None if there were too few samples for two cells.
    pub(crate) chi_squared_p: Option<f64>,
    /// 32-bit words a sample took: fewest and most.
    pub(crate) words: (u64, u64),
    /// Observed density of θ in each cell of the window, per radian.
    pub(crate) histogram: Vec<f64>,
    pub(crate) sweep: Sweep,
}

/// Running sums of a chunk.
struct Tally {
    sum_cos: f64,
    words: (u64, u64),
    /// The last cell collects what lies beyond the window.
    cells: [u64; CELLS + 1],
}

impl Tally {
    fn new() -> Self {
        Tally {
            sum_cos: 0.0,
            words: (u64::MAX, 0),
            cells: [0; CELLS + 1],
        }
    }

    fn add(&mut self, other: &Tally) {
        self.sum_cos += other.sum_cos;
        self.words.0 = self.words.0.min(other.words.0);
        self.words.1 = self.words.1.max(other.words.1);
        for (a, b) in self.cells.iter_mut().zip(other.cells) {
            *a += b;
        }
    }
}

fn sample<T: Number>(side: &Side<T>, count: u64, rng: &mut Counter) -> Tally {
    let (start, end) = side.shape.window();
    let mut tally = Tally::new();
    for _ in 0..count {
        let before = rng.words;
        let at = side.probe.draw(rng);
        let words = rng.words - before;
        tally.words = (tally.words.0.min(words), tally.words.1.max(words));
        tally.sum_cos += at.cos;
        let place = (at.sin.atan2(at.cos) - start) / (end - start) * CELLS as f64;
        // f32 rounds the ends of the support outwards: those samples stay in the end cells, while
        // those beyond a narrow lobe's window are counted apart.
        let beyond = end < 1.3 && place >= CELLS as f64;
        let cell = if beyond {
            CELLS
        } else {
            (place as usize).min(CELLS - 1)
        };
        tally.cells[cell] += 1;
    }
    tally
}

/// Measures one law in one number type; `work` numbers the pair.
pub(crate) fn measure<T: Number>(
    side: &Side<T>,
    samples: u64,
    seed: u64,
    work: u64,
    bar: &ProgressBar,
) -> Report {
    let chunks: Vec<Tally> = (0..samples.div_ceil(CHUNK))
        .into_par_iter()
        .map(|chunk| {
            let count = CHUNK.min(samples - chunk * CHUNK);
            let mut rng = Counter::new(stream(seed, (work << 40) | chunk));
            let tally = sample(side, count, &mut rng);
            bar.inc(count);
            tally
        })
        .collect();
    // In order: floating-point sums depend on it.
    let tally = chunks.iter().fold(Tally::new(), |mut all, chunk| {
        all.add(chunk);
        all
    });

    let n = samples as f64;
    let moments = side.probe.moments();
    let (exact_mean, variance): (f64, f64) = (moments.mean_cos.into(), moments.var_cos.into());
    let mean_cos = tally.sum_cos / n;
    // A narrow lobe's spread can lie below the format's rounding, which then is the error.
    let standard_error = (variance / n).sqrt().hypot(T::unit_roundoff());
    let (start, end) = side.shape.window();
    let width = (end - start) / CELLS as f64;
    Report {
        format: T::NAME,
        mean_cos,
        exact_mean,
        z: (mean_cos - exact_mean) / standard_error,
        chi_squared_p: chi_squared(side, samples, &tally.cells),
        words: tally.words,
        histogram: tally.cells[..CELLS]
            .iter()
            .map(|&count| count as f64 / n / width)
            .collect(),
        sweep: Sweep::of(side, samples, seed, work),
    }
}

/// χ² p-value of the cells, pooled from the left until each expects 5.
fn chi_squared<T: Number>(side: &Side<T>, samples: u64, cells: &[u64]) -> Option<f64> {
    let (start, end) = side.shape.window();
    let edge = |i: usize| start + (end - start) * i as f64 / CELLS as f64;
    let (mut expected, mut seen) = (0.0, 0.0);
    let mut pooled: Vec<(f64, f64)> = Vec::new();
    for (i, &count) in cells.iter().enumerate() {
        let upper = if i == CELLS {
            1.0
        } else {
            side.shape.cdf(edge(i + 1))
        };
        expected += samples as f64 * (upper - side.shape.cdf(edge(i))).max(0.0);
        seen += count as f64;
        if expected >= 5.0 {
            pooled.push((expected, seen));
            (expected, seen) = (0.0, 0.0);
        }
    }
    let last = pooled.last_mut()?;
    *last = (last.0 + expected, last.1 + seen);
    let statistic: f64 = pooled.iter().map(|(e, s)| (s - e) * (s - e) / e).sum();
    let law = ChiSquared::new(pooled.len() as f64 - 1.0).ok()?;
    Some(law.sf(statistic))
}
