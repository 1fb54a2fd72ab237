//! Violations that the proofs have to catch, each behind a feature.

#[cfg(feature = "plant-allocation")]
extern crate alloc;

/// `sum`, after whatever is planted.
pub(crate) fn planted(sum: f32, seed: u32) -> f32 {
    let _ = seed;
    #[cfg(feature = "plant-panic")]
    let sum = sum + [1.0, 2.0][seed as usize];
    #[cfg(feature = "plant-allocation")]
    let sum = *core::hint::black_box(alloc::boxed::Box::new(sum));
    #[cfg(feature = "plant-ram")]
    let sum = sum + {
        use core::sync::atomic::{AtomicU32, Ordering};
        static CALLS: AtomicU32 = AtomicU32::new(0);
        CALLS.store(seed, Ordering::Relaxed);
        core::hint::black_box(&CALLS).load(Ordering::Relaxed) as f32
    };
    #[cfg(feature = "plant-double")]
    let sum = (f64::from(sum) + 0.1) as f32;
    #[cfg(feature = "plant-float")]
    let sum = sum * 1.5;
    #[cfg(feature = "plant-law")]
    let sum = sum + coslobe::Law::warp(&coslobe::Disk, sum).cos;
    sum
}
