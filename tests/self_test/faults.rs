//! Every planted fault is named by a default test, or is listed as one that it cannot see.

use crate::generators::{self, Words};
use crate::samplers::{self, Verdict, judged};
use coslobe::self_test::{self, Fault, InPlane, InSpace, Statistic};
use coslobe::{Disk, Lambert};
use kit::catalogue::every_number;
use kit::{Number, NumberVisitor};

const SEEDS: std::ops::Range<u64> = 0..8;

/// How a fault is called in the tables of faults.
pub(crate) fn name(verdict: &Verdict) -> Option<String> {
    Some(match verdict {
        Ok(_) => return None,
        Err(Fault::Invalid { .. }) => "Invalid".into(),
        Err(Fault::Repeats { .. }) => "Repeats".into(),
        Err(Fault::TooUneven(score)) => format!("{:?}", score.statistic),
        Err(Fault::TooEven(score)) => format!("{:?} even", score.statistic),
        Err(other) => format!("{other:?}"),
    })
}

fn by_default(run: samplers::Run, rng: &mut Words) -> Verdict {
    run(rng, &[self_test::SAMPLES])[0]
}

fn lambert(rng: &mut Words) -> Verdict {
    by_default(
        |rng, at| judged(InSpace::<f32, _>::new(Lambert), rng, at),
        rng,
    )
}

/// What is listed as seen is seen at every seed, under that name; the rest is missed at one at
/// least.
fn agrees(fault: &str, found: &[Option<String>], expected: Option<&str>) {
    match expected {
        Some(names) => {
            let listed = |name: &String| names.split(" or ").any(|n| n == name);
            let all = found.iter().all(|f| f.as_ref().is_some_and(listed));
            assert!(all, "{fault}: {found:?}");
        }
        None => assert!(
            found.contains(&None),
            "{fault} is listed as not seen: {found:?}"
        ),
    }
}

#[test]
fn generators_are_judged_as_listed() {
    for (fault, make, expected) in generators::FAULTS {
        let mut found = Vec::new();
        for seed in SEEDS {
            found.push(name(&lambert(&mut make(seed))));
        }
        agrees(fault, &found, *expected);
    }
}

#[test]
fn samplers_are_judged_as_listed() {
    for (fault, run, expected) in samplers::FAULTS {
        let mut found = Vec::new();
        for seed in SEEDS {
            found.push(name(&by_default(*run, &mut generators::good(seed))));
        }
        agrees(fault, &found, *expected);
    }
}

/// Any of the 32 bits stuck at either value, and the verdict says which.
#[test]
fn every_stuck_bit_is_named() {
    for bit in 0..32 {
        for high in [false, true] {
            let Err(Fault::TooUneven(score)) = lambert(&mut generators::stuck_bit(1, bit, high))
            else {
                panic!("bit {bit} stuck is not seen");
            };
            assert_eq!((score.statistic, score.worst), (Statistic::Bits, bit as u8));
        }
    }
}

/// The same for the other number types and the plane: a generator's fault is no matter of the law.
#[test]
fn every_type_sees_a_biased_and_a_stuck_generator() {
    struct Types;
    impl NumberVisitor for Types {
        fn number<T: Number>(&mut self) {
            let runs: [samplers::Run; 2] = [
                |rng, at| judged(InSpace::<T, _>::new(Lambert), rng, at),
                |rng, at| judged(InPlane::<T, _>::new(Disk), rng, at),
            ];
            for run in runs {
                assert!(by_default(run, &mut generators::good(1)).is_ok());
                let biased = by_default(run, &mut generators::biased(1, !0, 0.05));
                assert_eq!(name(&biased).as_deref(), Some("Bits"));
                let short = by_default(run, &mut generators::period(1, 1 << 10));
                assert_eq!(name(&short).as_deref(), Some("Repeats"));
            }
        }
    }
    every_number(&mut Types);
}

/// Without the words, from samples alone: what a stuck top bit does to the law.
#[test]
fn samples_alone_show_a_stuck_top_bit() {
    use coslobe::Spatial;
    let mut rng = generators::stuck_bit(1, 31, true);
    let mut test = self_test::spatial::<f32, _>(Lambert);
    for _ in 0..self_test::SAMPLES {
        test.feed(&Spatial::sample(&Lambert, &mut rng));
    }
    let verdict = test.verdict(self_test::Alarm::OneInBillion);
    assert_eq!(name(&verdict).as_deref(), Some("Azimuth"));
}

/// Neither without a reason: the shortest period that is a power of two and too long to be seen.
#[test]
fn periods_are_seen_up_to_half_the_samples() {
    for (period, seen) in [(8191, true), (8192, true), (8193, false)] {
        let verdict = lambert(&mut generators::period(1, 3 * period));
        let found =
            matches!(verdict, Err(Fault::Repeats { period: p, .. }) if usize::from(p) == period);
        assert_eq!(found, seen, "{period} samples: {verdict:?}");
    }
}
