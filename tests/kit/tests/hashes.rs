//! The hashes of `hashes.txt` on this machine, whatever it is: unoptimised with overflow checks, or
//! big-endian under Miri (`cargo +nightly miri test --target s390x-unknown-linux-gnu`) or QEMU (the
//! same target, a cross linker, `qemu-s390x` as its runner: see `check`).
//!
//! `COSLOBE_LAST` at compile time says up to which count; 1048576 takes all that there are.

use coslobe::{Fast, Precise};
use kit::{Answer, Integers, Integers16, Laws, Stream, answer};

const EXPECTED: &str = include_str!("../../../examples/firmware/hashes.txt");

/// 64 where nothing is said: what Miri can run.
fn last() -> u32 {
    option_env!("COSLOBE_LAST").map_or(64, |last| last.parse().expect("COSLOBE_LAST is a count"))
}

fn hashes_in<T: Laws>() {
    for stream in Stream::ALL {
        let mut found = String::new();
        let last = last().min(stream.length()).to_string();
        let request = ["all", stream.name(), "checkpoints", &last];
        assert_eq!(
            answer::<T>(request.into_iter(), &mut found),
            Ok(Answer::Done)
        );
        assert!(!found.is_empty(), "no checkpoint up to {last}");
        for line in found.lines() {
            // Law, type, stream and count are in the line.
            assert!(EXPECTED.lines().any(|l| l == line), "not expected: {line}");
        }
    }
}

#[test]
fn f32_hashes() {
    hashes_in::<f32>();
}

#[test]
fn f64_hashes() {
    hashes_in::<f64>();
}

#[test]
fn fast_f32_hashes() {
    hashes_in::<Fast<f32>>();
}

#[test]
fn precise_f32_hashes() {
    hashes_in::<Precise<f32>>();
}

#[test]
fn precise_f64_hashes() {
    hashes_in::<Precise<f64>>();
}

#[test]
fn fixed_hashes() {
    hashes_in::<Integers>();
}

#[test]
fn fixed16_hashes() {
    hashes_in::<Integers16>();
}

/// One changed result changes the hash, wherever it is; so do two changed signs.
#[test]
fn no_change_cancels() {
    use kit::Hash;
    // Miri takes a minute for 5000 pairs.
    const STEPS: usize = if cfg!(miri) { 10 } else { 100 };
    let of = |flips: &[usize]| {
        let mut hash = Hash::default();
        (0..STEPS).for_each(|i| hash.add(u64::from(flips.contains(&i)) << 63));
        hash
    };
    for i in 0..STEPS {
        assert_ne!(of(&[]), of(&[i]));
        for j in 0..i {
            assert_ne!(of(&[]), of(&[i, j]));
        }
    }
}

#[test]
fn requests_that_make_no_sense_are_told_so() {
    for bad in [
        &["all", "sample", "checkpoints", "64"][..],
        &["all", "samples", "checkpoints"],
        &["all", "samples", "checkpoints", "-1"],
        &["all", "values", "blocks", "0", "64"],
        &["all", "values", "results", "0", "1"],
        &[],
    ] {
        let mut text = String::new();
        let answered = answer::<f32>(bad.iter().copied(), &mut text);
        assert_eq!(answered, Ok(Answer::NotUnderstood), "{bad:?}");
        assert!(text.contains("expected"), "{bad:?}");
    }
}
