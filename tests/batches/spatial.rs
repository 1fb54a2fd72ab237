//! Laws in space: directions of pairs, of words and of a generator.

use super::inputs::{LENGTHS, lengths_and_places, numbers, pairs};
use crate::same;
use coslobe::rand_core::Rng;
use coslobe::uniform::{TailBits, TurnBits};
use coslobe::{Batch, LengthError, Spatial};
use kit::{Named, Number};
use rand_pcg::{Pcg32, Pcg64};

/// Component `i` of each direction.
fn component<T: Copy>(all: &[[T; 3]], i: usize) -> impl Iterator<Item = T> {
    all.iter().map(move |d| d[i])
}

fn empty<T: Batch>(n: usize) -> [Vec<T>; 3] {
    std::array::from_fn(|_| vec![T::HALF; n])
}

fn slices<T>(all: &mut [Vec<T>; 3]) -> [&mut [T]; 3] {
    all.each_mut().map(|v| &mut v[..])
}

fn directions<T: Batch + Number, L: Spatial<T> + Named>(law: &L, width: &str) {
    let (u, v) = pairs::<T>();
    for len in LENGTHS.chain([u.len()]) {
        let mut out = empty(len);
        assert_eq!(
            law.warp_direction_slice([&u[..len], &v[..len]], slices(&mut out)),
            Ok(())
        );
        let scalar: Vec<_> = (0..len).map(|i| law.warp_direction([u[i], v[i]])).collect();
        for (i, out) in out.iter().enumerate() {
            let what = format!("{} {} direction {i}, {width}, {len}", L::ID.name(), T::NAME);
            same(&what, out, component(&scalar, i));
        }
    }
}

fn draws<T: Batch + Number, L: Spatial<T> + Named, R: Rng + Clone>(law: &L, rng: R, width: &str) {
    for (len, place) in lengths_and_places() {
        let (mut one, mut other) = (rng.clone(), rng.clone());
        let mut out = empty(place + len);
        let mut out = out.each_mut().map(|v| &mut v[place..]);
        let slices = out.each_mut().map(|v| &mut **v);
        assert_eq!(law.sample_slice(&mut one, slices), Ok(()));
        let scalar: Vec<_> = (0..len).map(|_| law.sample(&mut other)).collect();
        for (i, out) in out.iter().enumerate() {
            let what = format!("{} {} sample {i}, {width}, {len}", L::ID.name(), T::NAME);
            same(&what, out, component(&scalar, i));
        }
        assert_eq!(
            one.next_u64(),
            other.next_u64(),
            "{} {}: state",
            L::ID.name(),
            T::NAME
        );
    }
}

fn words<T: Batch + Number, L: Spatial<T> + Named>(
    law: &L,
    theta: &[TailBits<T>],
    phi: &[TurnBits<T>],
    width: &str,
) {
    for len in LENGTHS.chain([theta.len()]) {
        let (theta, phi) = (&theta[..len], &phi[..len]);
        let mut out = empty(len);
        assert_eq!(
            law.sample_from_bits_slice(theta, phi, slices(&mut out)),
            Ok(())
        );
        let scalar: Vec<_> = (0..len)
            .map(|i| law.sample_from_bits(theta[i], phi[i]))
            .collect();
        for (i, out) in out.iter().enumerate() {
            let what = format!("{} {} words {i}, {width}, {len}", L::ID.name(), T::NAME);
            same(&what, out, component(&scalar, i));
        }
    }
}

/// Each slice in turn too long or too short: an error, no word drawn, nothing written.
fn unequal<T: Batch + Number, L: Spatial<T>>(law: &L, theta: &[TailBits<T>], phi: &[TurnBits<T>]) {
    let input = numbers::<T>();
    for wrong in 0..5 {
        for other in [0, 63, 65, 128] {
            let mut n = [64; 5];
            n[wrong] = other;
            let mut out = [n[2], n[3], n[4]].map(|n| vec![T::HALF; n]);
            let error = |of: &[usize]| {
                let found = *of.iter().find(|&&n| n != of[0])?;
                Some(Err(LengthError {
                    expected: of[0],
                    found,
                }))
            };
            let pair = [&input[..n[0]], &input[..n[1]]];
            assert_eq!(
                Some(law.warp_direction_slice(pair, slices(&mut out))),
                error(&n)
            );
            let (theta, phi) = (&theta[..n[0]], &phi[..n[1]]);
            assert_eq!(
                Some(law.sample_from_bits_slice(theta, phi, slices(&mut out))),
                error(&n)
            );
            if let Some(error) = error(&n[2..]) {
                let mut rng = Pcg32::new(1, 2);
                assert_eq!(law.sample_slice(&mut rng, slices(&mut out)), error);
                assert_eq!(rng, Pcg32::new(1, 2), "drawn");
            }
            assert!(out.iter().flatten().all(|&x| x == T::HALF), "written");
        }
    }
}

/// Every function of slices that laws in space have beside those of `Law`.
pub(crate) fn law<T: Batch + Number, L: Spatial<T> + Named>(
    law: &L,
    theta: &[TailBits<T>],
    phi: &[TurnBits<T>],
    width: &str,
) {
    directions(law, width);
    draws(law, Pcg32::new(1, 2), width);
    draws(law, Pcg64::new(1, 2), width);
    words(law, theta, phi, width);
    unequal(law, theta, phi);
    let (mut rng, mut same) = (Pcg32::new(3, 4), Pcg32::new(3, 4));
    let mut out = empty(65);
    let by_reference: &mut dyn Rng = &mut rng;
    assert_eq!(law.sample_slice(by_reference, slices(&mut out)), Ok(()));
    assert_eq!(
        out[1][64],
        (0..65)
            .map(|_| law.sample(&mut same)[1])
            .last()
            .expect("65")
    );
}
