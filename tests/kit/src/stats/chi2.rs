//! Pearson's χ² test.

use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Cells below this expected count are pooled: the χ² distribution is an approximation for large
/// counts.
const LEAST: f64 = 5.0;

/// p-value of (observed, expected) cells. A count in a cell that expects none gives 0.
pub fn p_value(cells: impl IntoIterator<Item = (u64, f64)>) -> f64 {
    let mut kept: Vec<(f64, f64)> = Vec::new();
    let mut pool = (0.0, 0.0);
    for (observed, expected) in cells {
        if expected <= 0.0 && observed > 0 {
            return 0.0;
        }
        if expected >= LEAST {
            kept.push((observed as f64, expected));
        } else {
            pool = (pool.0 + observed as f64, pool.1 + expected);
        }
    }
    if pool.1 < LEAST {
        let (observed, expected) = kept.pop().unwrap_or_default();
        pool = (pool.0 + observed, pool.1 + expected);
    }
    kept.push(pool);
    assert!(kept.len() > 1, "too few samples for a χ² test");
    let statistic = kept.iter().map(|(o, e)| (o - e) * (o - e) / e).sum();
    let freedom = (kept.len() - 1) as f64;
    ChiSquared::new(freedom).unwrap().sf(statistic)
}

/// p-value of counts that are all equally likely; none at all say nothing.
pub fn uniform(counts: &[u64]) -> f64 {
    if counts.iter().all(|&count| count == 0) {
        return 1.0;
    }
    let expected = counts.iter().sum::<u64>() as f64 / counts.len() as f64;
    p_value(counts.iter().map(|&observed| (observed, expected)))
}
