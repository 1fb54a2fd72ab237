//! The sweep of the tail: how far cos θ is from the truth, the crate's and the hand-rolled one's.

use crate::number::Number;
use crate::probe::Side;
use crate::random::stream;
use coslobe::rand_core::Rng;
use kit::accuracy::double::Double;
use rayon::prelude::*;

/// Points of each curve.
const BINS: u64 = 96;

/// Worst errors over bins of the tail.
pub(crate) struct Sweep {
    /// Inputs tried.
    pub(crate) tried: u64,
    /// (log₁₀ p, worst relative error) of the crate's warp.
    pub(crate) crate_error: Vec<(f64, f64)>,
    /// The same of the textbook's formula.
    pub(crate) hand_rolled_error: Vec<(f64, f64)>,
    pub(crate) worst_ulp: f64,
    /// The input of `worst_ulp` in hex.
    pub(crate) worst_input: String,
}

/// One bin's worst.
struct Bin {
    log_p: f64,
    ours: f64,
    theirs: f64,
    ulp: f64,
    input: String,
}

/// log₁₀(−log₁₀ p): spreads a tail of 300 decades so that ½ and 10⁻³⁸ are both readable.
pub(crate) fn stretch(log_p: f64) -> f64 {
    (-log_p).log10()
}

impl Sweep {
    pub(crate) fn of<T: Number>(side: &Side<T>, samples: u64, seed: u64, work: u64) -> Sweep {
        let per_bin = (samples / BINS / 4).clamp(32, 2048);
        let (near, far) = (stretch(0.5f64.log10()), stretch(T::LEAST_TAIL.log10()));
        let bins: Vec<Bin> = (0..BINS)
            .into_par_iter()
            .map(|i| {
                let start = near + (far - near) * i as f64 / BINS as f64;
                let width = (far - near) / BINS as f64;
                // Bit 39 sets these generators apart from the sampling's.
                let mut rng = stream(seed, (work << 40) | (1 << 39) | i);
                let mut worst = Bin::new(-(10f64.powf(start + width / 2.0)));
                for j in 0..per_bin {
                    // Jittered; the first of all is exactly ½.
                    let jitter = if j == 0 {
                        0.0
                    } else {
                        f64::from(rng.next_u32()) * 2f64.powi(-32)
                    };
                    let x = start + width * (j as f64 + jitter) / per_bin as f64;
                    let p = 10f64.powf(-(10f64.powf(x))).clamp(T::LEAST_TAIL, 0.5);
                    worst.try_input(side, T::of(p));
                }
                worst
            })
            .collect();
        let worst = bins
            .iter()
            .fold(&bins[0], |a, b| if b.ulp > a.ulp { b } else { a });
        Sweep {
            tried: BINS * per_bin,
            crate_error: bins.iter().map(|b| (b.log_p, b.ours)).collect(),
            hand_rolled_error: bins.iter().map(|b| (b.log_p, b.theirs)).collect(),
            worst_ulp: worst.ulp,
            worst_input: worst.input.clone(),
        }
    }
}

impl Bin {
    fn new(log_p: f64) -> Bin {
        Bin {
            log_p,
            ours: 0.0,
            theirs: 0.0,
            ulp: -1.0,
            input: String::new(),
        }
    }

    fn try_input<T: Number>(&mut self, side: &Side<T>, p: T) {
        let truth = side.shape.cos_at(p.into());
        let ours = distance(side.probe.cos_at(p), truth);
        let theirs = distance(side.shape.hand_rolled(p), truth);
        self.ours = self.ours.max(ours / truth.hi);
        self.theirs = self.theirs.max(theirs / truth.hi);
        let ulp = ours / T::ulp(truth.hi);
        if ulp > self.ulp {
            self.ulp = ulp;
            self.input = p.hex();
        }
    }
}

/// |x − truth|; a NaN is as far off as can be.
fn distance<T: Number>(x: T, truth: Double) -> f64 {
    let d = (truth - Double::from(x.into())).hi.abs();
    if d.is_nan() { f64::INFINITY } else { d }
}
