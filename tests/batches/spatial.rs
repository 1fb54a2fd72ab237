//! Laws in space: directions of pairs, of words and of a generator.

use super::inputs::{LENGTHS, noise, numbers, pairs};
use crate::{at_every_width, same};
use coslobe::rand_core::Rng;
use coslobe::uniform::{TailBits, TurnBits};
use coslobe::{Ball, Batch, CosPower, Fast, Lambert, LengthError, Spatial, SphereShell};
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
    for len in LENGTHS.chain([1000]) {
        let (mut one, mut other) = (rng.clone(), rng.clone());
        let mut out = empty(len);
        assert_eq!(law.sample_slice(&mut one, slices(&mut out)), Ok(()));
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

fn law<T: Batch + Number, L: Spatial<T> + Named>(
    law: L,
    theta: &[TailBits<T>],
    phi: &[TurnBits<T>],
    width: &str,
) {
    directions(&law, width);
    draws(&law, Pcg32::new(1, 2), width);
    draws(&law, Pcg64::new(1, 2), width);
    words(&law, theta, phi, width);
    unequal(&law, theta, phi);
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

fn every_law<T: Batch + Number>(theta: &[TailBits<T>], phi: &[TurnBits<T>]) {
    at_every_width(|width| {
        law::<T, _>(Ball, theta, phi, width);
        law::<T, _>(SphereShell, theta, phi, width);
        law::<T, _>(Lambert, theta, phi, width);
        for k in [0.0, 7.3, 1e4] {
            law::<T, _>(
                CosPower::new(T::of(k)).expect("an exponent"),
                theta,
                phi,
                width,
            );
        }
    });
}

/// Words whose leading zeros, or ones, are of every number.
pub(crate) fn hard_words() -> Vec<u64> {
    let ends = [0, 1, u64::MAX, 1 << 63, (1 << 63) - 1, 1 << 61, 3 << 61];
    let noisy = (0..64).flat_map(|n| [noise(n) >> n, !(noise(n) >> n), 1 << n]);
    ends.into_iter()
        .chain(noisy)
        .chain((0..300).map(noise))
        .collect()
}

/// Words of twice the length: each with noise, zeros and ones below it.
pub(crate) fn hard_double_words() -> Vec<u128> {
    let lower = |n: u64| [0, u64::MAX, noise(n), noise(n) >> (n & 63)];
    let pair = |high: u64| lower(high).map(|low| u128::from(high) << 64 | u128::from(low));
    hard_words().into_iter().flat_map(pair).collect()
}

/// As many as `n`, from the upper and from the lower bits of hard words.
pub(crate) fn hard_halves(n: usize) -> Vec<u32> {
    let halves = |w: u64| [(w >> 32) as u32, w as u32];
    hard_words()
        .into_iter()
        .rev()
        .flat_map(halves)
        .cycle()
        .take(n)
        .collect()
}

#[test]
fn f32_directions() {
    let theta = hard_words();
    every_law::<f32>(&theta, &hard_halves(theta.len()));
}

#[test]
fn f64_directions() {
    let theta = hard_double_words();
    let phi: Vec<_> = hard_words()
        .into_iter()
        .rev()
        .cycle()
        .take(theta.len())
        .collect();
    every_law::<f64>(&theta, &phi);
}

#[test]
fn fast_directions() {
    let phi = hard_halves(700);
    let theta: Vec<_> = phi.iter().rev().copied().collect();
    every_law::<Fast<f32>>(&theta, &phi);
}
