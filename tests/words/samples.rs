//! Samples in the plane that are the warp of their word's one uniform.

use coslobe::uniform::{TailBits, tails_from_bits};
use coslobe::{CircleArc, CircleShell, Planar};
use kit::Number;
use kit::stats::words;
use rand_pcg::rand_core::Rng;

fn is_the_warp<T: Number, L: Planar<T>>(law: L, word: TailBits<T>, error: f64) {
    let at = law.warp_tails(tails_from_bits::<T>(word));
    let sample = law.sample_from_bits(word);
    for (found, expected) in sample.into_iter().zip([at.sin, at.cos]) {
        let off = (found.wide() - expected.wide()).abs();
        assert!(off <= error, "{}: {sample:?} for {at:?}", T::NAME);
    }
}

#[test]
fn samples_in_the_plane_are_warps() {
    let mut rng = words::pcg("warps");
    for _ in 0..10_000 {
        let word = rng.next_u64();
        is_the_warp::<f32, _>(CircleShell, word, 1e-6);
        is_the_warp::<f32, _>(CircleArc, word, 1e-6);
        let long = u128::from(word) << 64 | u128::from(rng.next_u64());
        is_the_warp::<f64, _>(CircleShell, long, 1e-14);
        is_the_warp::<f64, _>(CircleArc, long, 1e-14);
    }
}
