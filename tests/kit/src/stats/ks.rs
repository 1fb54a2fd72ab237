//! Kolmogorov–Smirnov test for U(0, 1).

/// p-value that `u` is uniform in \[0, 1\]; sorts it.
///
/// `statrs::stats_tests::ks_test` stops its series at 1e-10, which is the size of the p-values
/// that decide here, and does not end for a statistic of 0.
pub fn uniform(u: &mut [f64]) -> f64 {
    u.sort_unstable_by(f64::total_cmp);
    let n = u.len() as f64;
    let distance = u.iter().enumerate().fold(0.0, |d: f64, (i, &u)| {
        d.max(u - i as f64 / n).max((i + 1) as f64 / n - u)
    });
    // Stephens' correction of the asymptotic law for finite n.
    kolmogorov((n.sqrt() + 0.12 + 0.11 / n.sqrt()) * distance)
}

/// P(K > x) of Kolmogorov's distribution.
fn kolmogorov(x: f64) -> f64 {
    if x < 0.3 {
        return 1.0; // to 1e-5, where the alternating series would need many terms
    }
    let term = |k: i32| (-2.0 * f64::from(k * k) * x * x).exp();
    let sum: f64 = (1..20)
        .map(|k| if k % 2 == 1 { term(k) } else { -term(k) })
        .sum();
    (2.0 * sum).min(1.0)
}
