//! Every operation against true values: sweeps against wider arithmetic.

use coslobe::{Disk, Law};
use kit::accuracy::bounds::broken;
use kit::accuracy::format::Format;
use kit::accuracy::inputs::exponents;
use kit::accuracy::measure::{Input, judge, sample, sweep};
use kit::accuracy::monotone;
use kit::accuracy::part::Part;
use kit::accuracy::reference::{self, Direction, Id};
use kit::accuracy::rows::{Row, from_json, keys, measure_all, to_json};
use kit::accuracy::subject::{Subject, Tiers};
use kit::accuracy::tally::Tally;
use kit::promises_ulps;

fn holds<T: Format>(subjects: &[Subject<T>], tally: &Tally) {
    let broken = broken(subjects, tally);
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

fn swept<T: Tiers>(ids: &[Id], stride: u64) {
    let subjects = Subject::<T>::all(ids);
    for input in Input::ALL {
        holds(
            &subjects,
            &sweep(&subjects, input, stride, Part::WHOLE, |_| ()),
        );
    }
}

fn sampled<T: Tiers>(ids: &[Id], n: u64) {
    let subjects = Subject::<T>::all(ids);
    for input in Input::ALL {
        holds(&subjects, &sample(&subjects, input, n, Part::WHOLE, |_| ()));
    }
}

#[test]
fn f32_strided() {
    swept::<f32>(&Id::FIXED, 1009);
}

#[test]
#[ignore = "opt-in, half an hour for each number type: cargo test --release --test errors -- --ignored"]
fn f32_exhaustive() {
    swept::<f32>(&Id::FIXED, 1);
}

#[test]
fn f64_stratified() {
    sampled::<f64>(&Id::FIXED, 1_000_002);
}

#[test]
fn real_exponents() {
    sampled::<f32>(&exponents::<f32>(), 100_002);
    sampled::<f64>(&exponents::<f64>(), 60_000);
}

fn never_steps_back<T: Format>(
    find: impl Fn(&Subject<T>) -> (u64, u64),
    tiers: impl Fn(Id) -> Vec<Subject<T>>,
) {
    let all = Id::FIXED.into_iter().flat_map(tiers);
    for s in all.filter(|s| promises_ulps(s.tier)) {
        let (bad, first) = find(&s);
        assert_eq!(
            bad, 0,
            "{} {:?}: quantile or isf steps back or does not mirror from {first:#x}",
            s.tier, s.id
        );
    }
}

/// The logarithm of a narrow lobe's density at the angles where the density passes 1.
fn crosses_zero<T: Tiers>() {
    for k in [1e3, 1e6, 1e30] {
        let subjects = Subject::<T>::all(&[Id::CosPower(k)]);
        let peak = 1.0 / (k + 1.0).sqrt();
        for (mut above, mut below) in [(peak, peak * 60.0), (peak, peak * 1e-12 / k)] {
            let value = |theta: f64| {
                let at = Direction::<f64>::at_angle(theta.min(1.57));
                reference::ln_pdf(Id::CosPower(k), &at)
            };
            assert!(
                value(above) > 0.0 && value(below) < 0.0,
                "{k:e} from {above:e} to {below:e}"
            );
            for _ in 0..200 {
                let middle = (above + below) / 2.0;
                if value(middle) > 0.0 {
                    above = middle
                } else {
                    below = middle
                }
            }
            let middle = T::of(below).bits();
            let around: Vec<_> = (middle - 200..middle + 200).map(T::of_bits).collect();
            let tally = judge(&subjects, Input::Angle, &around);
            holds(&subjects, &tally);
        }
    }
}

#[test]
fn logarithms_that_cross_zero() {
    crosses_zero::<f32>();
    crosses_zero::<f64>();
}

/// 1 − cosⁿθ of an angle with few digits lies beside a tie, by less than any format tells.
#[test]
fn short_angles_round_to_the_right_side() {
    let spatial = Id::FIXED.into_iter().filter(|id| !id.planar());
    let ids: Vec<_> = spatial.chain([0.0, 0.5, 1.0].map(Id::CosPower)).collect();
    let subjects = Subject::<f32>::all(&ids);
    let bits = (0..0x3F80_0000).step_by(1 << 11);
    let angles: Vec<_> = bits.map(f32::from_bits).collect();
    holds(&subjects, &judge(&subjects, Input::Angle, &angles));
}

/// `cdf` and `sf` may step back between neighbours, by as much as `Law` says, and of `Precise`
/// never.
fn steps_back_by<F: Tiers>(n: u64) {
    let all = Subject::<F>::all(&Id::FIXED).into_iter();
    for s in all.filter(|s| promises_ulps(s.tier)) {
        let (worst, at) = monotone::tails_step_back(&s, n);
        println!("{} {:?}: {worst} ulp at {at:#x}", s.tier, s.id);
        let allowed = if s.tier.starts_with("Precise") {
            0.0
        } else {
            4.0
        };
        assert!(
            worst <= allowed,
            "{} {:?}: {worst} ulp at {at:#x}",
            s.tier,
            s.id
        );
    }
}

#[test]
fn tails_step_back_by_ulps() {
    steps_back_by::<f32>(200_001);
    steps_back_by::<f64>(200_001);
    let [theta, next] = [0x3fdf_ffff_fffb_6c2f, 0x3fdf_ffff_fffb_6c30].map(f64::from_bits);
    assert!(Disk.sf(theta) < Disk.sf(next), "the docs may promise more");
}

#[test]
fn quantiles_are_monotone_and_odd() {
    never_steps_back(|s| monotone::strided(s, 101, Part::WHOLE), f32::tiers);
    never_steps_back(|s| monotone::sampled(s, 1_000_000, Part::WHOLE), f64::tiers);
}

#[test]
#[ignore = "opt-in, minutes: cargo test --release --test errors -- --ignored"]
fn f32_quantiles_are_monotone_everywhere() {
    never_steps_back(|s| monotone::strided(s, 1, Part::WHOLE), f32::tiers);
}

/// Threads may finish in any order; the table is the same, and JSON keeps it.
#[test]
fn measuring_twice_gives_the_same_rows() {
    let rows = measure_all(100_003, 3000, Part::WHOLE, |_| ());
    assert_eq!(rows, measure_all(100_003, 3000, Part::WHOLE, |_| ()));
    assert_eq!(rows.iter().map(Row::key).collect::<Vec<_>>(), keys());
    let text = to_json(&rows).expect("JSON");
    assert_eq!(from_json(&text).expect("rows"), rows);
}

/// Parts that are merged in their order are the whole, to the last digit.
#[test]
fn parts_make_the_whole() {
    let part = |index, of| measure_all(1_000_003, 300, Part { index, of }, |_| ());
    let merged = (2..=3).fold(part(1, 3), |rows, index| {
        let next = part(index, 3).into_iter();
        let pairs = rows.into_iter().zip(next);
        pairs.map(|(row, next)| row.merge(next)).collect()
    });
    for (merged, whole) in merged.iter().zip(&part(1, 1)) {
        assert_eq!(merged, whole);
    }
}
