//! Planted errors, each of which the judges of `sweeps` must notice.

use coslobe::{Ball, CircleShell, CosSin, Law};
use kit::accuracy::bounds::broken;
use kit::accuracy::format::Format;
use kit::accuracy::measure::{Input, sweep};
use kit::accuracy::op::Op;
use kit::accuracy::part::Part;
use kit::accuracy::reference::Id;
use kit::accuracy::spoiled::{Altered, Spoiled};
use kit::accuracy::subject::Subject;
use kit::accuracy::tally::{Stat, Tally};

fn rejects<T: Format>(spoiled: Spoiled, stride: u64) {
    let subjects = [Subject::<T>::planar::<T>(Id::Disk, spoiled)];
    let tally = sweep(&subjects, Input::Angle, stride, Part::WHOLE, |_| ());
    assert!(!broken(&subjects, &tally).is_empty());
}

#[test]
fn gross_errors() {
    for spoiled in [
        Spoiled::NaiveCosine,
        Spoiled::OneMinus,
        Spoiled::NaiveResidual,
        Spoiled::Nudged,
    ] {
        rejects::<f32>(spoiled, 1009);
    }
    rejects::<f64>(Spoiled::OneMinus, 1 << 43);
    rejects::<f64>(Spoiled::NaiveResidual, 1 << 43);
}

/// A law under another's name is caught too: the ball's volume is not its surface.
#[test]
fn a_wrong_exponent() {
    let subjects = [Subject::<f32>::planar::<f32>(Id::Lambert, Ball)];
    let tally = sweep(&subjects, Input::Tail, 100_003, Part::WHOLE, |_| ());
    assert!(!broken(&subjects, &tally).is_empty());
}

fn tally_of(
    id: Id,
    law: impl Law<f32> + Send + Sync + 'static,
    input: Input,
) -> (Vec<String>, Tally) {
    let subjects = [Subject::<f32>::planar::<f32>(id, law)];
    let tally = sweep(&subjects, input, 1009, Part::WHOLE, |_| ());
    (broken(&subjects, &tally), tally)
}

fn stat(tally: &Tally, op: Op) -> &Stat {
    &tally.0[0][op as usize]
}

/// sin θ = 1 − 2p of `CircleShell` is correctly rounded, until one input of a million is not.
#[test]
fn one_ulp_at_one_input() {
    let altered = |at: f32, steps: i32| Altered {
        warp: move |p: f32, at_p: CosSin<f32>| {
            let bits = at_p.sin.to_bits().wrapping_add_signed(steps);
            let sin = if p == at {
                f32::from_bits(bits)
            } else {
                at_p.sin
            };
            CosSin { sin, ..at_p }
        },
        pdf: |_, value| value,
    };
    // The sweep is aligned to the top, ½.
    let at = f32::from_bits(0x3F00_0000 - 1009 * 10_000);
    let (_, tally) = tally_of(Id::CircleShell, altered(at, 0), Input::Tail);
    assert_eq!(stat(&tally, Op::WarpSfSin).misrounded_count(), 0);
    let (broken, tally) = tally_of(Id::CircleShell, altered(at, 1), Input::Tail);
    let sin = stat(&tally, Op::WarpSfSin);
    assert_eq!(sin.misrounded, [u64::from(at.to_bits())]);
    assert_eq!(sin.misrounded_count(), 1);
    assert!(
        broken
            .iter()
            .any(|b| b.contains("warp_sf: sin: 1 misrounded"))
    );
}

/// 1 − 2p for a p of 24 bits below ¼ is half-way between two numbers: its error is ½ ulp on either
/// side, and only one of them is even.
#[test]
fn a_tie_rounded_the_wrong_way() {
    let at = (0..1000)
        .map(|i| f32::from_bits(0x3F00_0000 - 1009 * (9000 + i)))
        .find(|p| p.to_bits() % 2 == 1 && (0.125..0.25).contains(p))
        .expect("an odd p below ¼");
    let altered = Altered {
        warp: move |p: f32, at_p: CosSin<f32>| {
            let exact = 1.0 - 2.0 * f64::from(p);
            let wrong = if f64::from(at_p.sin) > exact { -1 } else { 1 };
            let bits = at_p.sin.to_bits().wrapping_add_signed(wrong);
            let sin = if p == at {
                f32::from_bits(bits)
            } else {
                at_p.sin
            };
            CosSin { sin, ..at_p }
        },
        pdf: |_, value| value,
    };
    let (broken, tally) = tally_of(Id::CircleShell, altered, Input::Tail);
    let sin = stat(&tally, Op::WarpSfSin);
    assert!(sin.ties > 1000);
    assert_eq!(sin.ulps, 0.5);
    assert_eq!(sin.misrounded, [u64::from(at.to_bits())]);
    assert!(
        broken
            .iter()
            .any(|b| b.contains("warp_sf: sin: 1 misrounded"))
    );
}

/// An f64 result rounded to f32 is right but for one input in 2²⁷ or so; with an error of 2⁻⁴⁰
/// before the rounding it is wrong some thirty times in a million, by ½ ulp and a trace.
#[test]
fn a_rounded_f64_with_a_small_error() {
    let rounded = |error: f64| Altered {
        warp: move |p: f32, at: CosSin<f32>| {
            let p = f64::from(p);
            let cos = 2.0 * (p * (1.0 - p)).sqrt() * (1.0 + error);
            CosSin {
                cos: cos as f32,
                ..at
            }
        },
        pdf: |_, value| value,
    };
    let (_, tally) = tally_of(Id::CircleShell, rounded(0.0), Input::Tail);
    assert_eq!(stat(&tally, Op::WarpSfCos).misrounded_count(), 0);
    let (_, tally) = tally_of(Id::CircleShell, rounded(2f64.powi(-40)), Input::Tail);
    let cos = stat(&tally, Op::WarpSfCos);
    assert!(cos.misrounded_count() > 10, "{}", cos.misrounded_count());
    assert!(cos.ulps > 0.5 && cos.ulps < 0.5001, "{}", cos.ulps);
}

/// `CircleShell` itself is untouched where nothing was altered.
#[test]
fn what_is_right_passes() {
    let (broken, _) = tally_of(Id::CircleShell, CircleShell, Input::Tail);
    assert!(broken.is_empty(), "{broken:?}");
}
