//! Violations that the proofs have to catch, each behind a feature.

#[cfg(feature = "plant-allocation")]
extern crate alloc;

/// `sum`, after whatever is planted.
pub(crate) fn planted(sum: u32, seed: u32) -> u32 {
    let _ = seed;
    #[cfg(feature = "plant-panic")]
    let sum = sum ^ [1, 2][seed as usize];
    #[cfg(feature = "plant-overflow")]
    let sum = sum + seed;
    #[cfg(feature = "plant-allocation")]
    let sum = *core::hint::black_box(alloc::boxed::Box::new(sum));
    #[cfg(feature = "plant-ram")]
    let sum = sum ^ {
        use core::sync::atomic::{AtomicU32, Ordering};
        static CALLS: AtomicU32 = AtomicU32::new(0);
        CALLS.store(seed, Ordering::Relaxed);
        core::hint::black_box(&CALLS).load(Ordering::Relaxed)
    };
    #[cfg(feature = "plant-double")]
    let sum = (f64::from(f32::from_bits(sum)) + 0.1).to_bits() as u32;
    #[cfg(feature = "plant-float")]
    let sum = (f32::from_bits(sum) * 1.5).to_bits();
    #[cfg(feature = "plant-law")]
    let sum = sum
        ^ coslobe::Law::warp(&coslobe::Disk, f32::from_bits(sum))
            .cos
            .to_bits();
    sum
}
