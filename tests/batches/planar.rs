//! Laws in the plane: directions of words and of a generator.

use super::inputs::{LENGTHS, lengths_and_places};
use crate::same;
use coslobe::rand_core::Rng;
use coslobe::uniform::TailBits;
use coslobe::{Batch, LengthError, Planar};
use kit::{Named, Number};
use rand_pcg::{Pcg32, Pcg64};

fn draws<T: Batch + Number, L: Planar<T> + Named, R: Rng + Clone>(law: &L, rng: R, width: &str) {
    for (len, place) in lengths_and_places() {
        let (mut one, mut other) = (rng.clone(), rng.clone());
        let [mut sin, mut cos] = [(); 2].map(|()| vec![T::HALF; place + len]);
        let (sin, cos) = (&mut sin[place..], &mut cos[place..]);
        assert_eq!(law.sample_slice(&mut one, [sin, cos]), Ok(()));
        let scalar: Vec<_> = (0..len).map(|_| law.sample(&mut other)).collect();
        let what = format!("{} {} sample, {width}, {len}", L::ID.name(), T::NAME);
        same(&what, sin, scalar.iter().map(|d| d[0]));
        same(&what, cos, scalar.iter().map(|d| d[1]));
        assert_eq!(one.next_u64(), other.next_u64(), "{what}: state");
    }
}

fn words<T: Batch + Number, L: Planar<T> + Named>(law: &L, words: &[TailBits<T>], width: &str) {
    for len in LENGTHS.chain([words.len()]) {
        let words = &words[..len];
        let (mut sin, mut cos) = (vec![T::HALF; len], vec![T::HALF; len]);
        assert_eq!(
            law.sample_from_bits_slice(words, [&mut sin, &mut cos]),
            Ok(())
        );
        let what = format!("{} {} words, {width}, {len}", L::ID.name(), T::NAME);
        let scalar: Vec<_> = words
            .iter()
            .map(|&word| law.sample_from_bits(word))
            .collect();
        same(&what, &sin, scalar.iter().map(|d| d[0]));
        same(&what, &cos, scalar.iter().map(|d| d[1]));
    }
}

fn unequal<T: Batch + Number, L: Planar<T>>(law: &L, words: &[TailBits<T>]) {
    for (expected, found) in [(64, 63), (64, 65), (0, 1), (65, 0)] {
        let (mut sin, mut cos) = (vec![T::HALF; expected], vec![T::HALF; found]);
        let error = Err(LengthError { expected, found });
        let mut rng = Pcg32::new(1, 2);
        assert_eq!(law.sample_slice(&mut rng, [&mut sin, &mut cos]), error);
        assert_eq!(rng, Pcg32::new(1, 2), "drawn");
        assert_eq!(
            law.sample_from_bits_slice(&words[..expected], [&mut sin, &mut cos]),
            error
        );
        assert!(sin.iter().chain(&cos).all(|&x| x == T::HALF), "written");
    }
}

/// Every function of slices that laws in the plane have beside those of `Law`.
pub(crate) fn law<T: Batch + Number, L: Planar<T> + Named>(
    law: &L,
    all: &[TailBits<T>],
    width: &str,
) {
    draws(law, Pcg32::new(1, 2), width);
    draws(law, Pcg64::new(1, 2), width);
    words(law, all, width);
    unequal(law, all);
}
