//! What every law keeps, in space or in the plane.

use super::format::{Law, wide};
use crate::input::{Input, Words};
use coslobe::CosSin;
use fixed::types::U16F16;
use kit::Id;
use kit::integer::truth::{Truth, power_pair};
use std::f64::consts::TAU;

/// An operation's error in units of its last place, for the worst of the laws.
const PAIR_UNITS: f64 = 4.0;
const TAIL_UNITS: f64 = 7.0;
const TURN_UNITS: f64 = 3.0;
const WEIGHT_UNITS: f64 = 3.0;
/// Of `CosPower`, whose exponent multiplies the error of a cosine; its density has units of 2⁻¹⁶.
const POWER_TAIL_UNITS: f64 = 180.0;
const POWER_DENSITY_UNITS: f64 = 1.6;

#[track_caller]
pub(super) fn assert_near(got: f64, want: f64, units: f64, of: f64, what: &str) {
    // 1 saturates to one unit less.
    let off = ((got - want) * of).abs();
    assert!(
        off <= units || (want >= 1.0 - 1.0 / of && off <= units + 1.0),
        "{what}: {got:?} is {off} units from {want:?}"
    );
}

#[track_caller]
pub(super) fn assert_unit<L: Law>(v: &[L::Component], units: f64) {
    let length = v.iter().map(|&c| wide(c).powi(2)).sum::<f64>().sqrt();
    let off = (length - 1.0).abs() * L::COMPONENT;
    assert!(off <= units, "{v:?} has length {length}");
}

/// Any two words, direction or not.
pub(super) fn pairs<L: Law>(law: L, id: Id, input: &mut Input) {
    let (cos, sin) = (
        L::component(input.words.word()),
        L::component(input.words.word()),
    );
    let at = CosSin { cos, sin };
    let density = law.density(at);
    let rim = wide(cos) == 0.0 && id.exponent() == 0.0;
    let open = (wide(cos) > 0.0 || rim) && (id.planar() || wide(sin) >= 0.0);
    assert_eq!(density > 0.0, open, "density {density:?} at {at:?}");
    let [cdf, sf] = law.unwarps(at);
    assert_near(cdf + sf, 1.0, 4.0, L::PROBABILITY, "unwarp + unwarp_sf");
    if !matches!(id, Id::CosPower(_)) {
        let want = if open {
            Truth::of(id).density_at(wide(cos))
        } else {
            0.0
        };
        assert_near(density, want, PAIR_UNITS, L::PROBABILITY, "density");
    }
    let weight = law.lambert_weight(at);
    match id {
        _ if !open && wide(cos) != 0.0 => assert_eq!(weight, 0, "weight outside, at {at:?}"),
        Id::CosPower(_) => {}
        _ if wide(sin) < 0.0 && !id.planar() => {}
        _ => {
            let most = wide(U16F16::MAX);
            let want = Truth::of(id).weight_at(wide(cos)).min(most);
            let unit = if L::SHORT {
                2f64.powi(-14)
            } else {
                2f64.powi(-28)
            };
            let off = (wide(weight) - want).abs() / (want * unit).max(2f64.powi(-16));
            assert!(
                off <= WEIGHT_UNITS,
                "weight {weight} is {off} units from {want} at {at:?}"
            );
        }
    }
    // Outside the support: in the plane on the side of sin θ, in space below the axis first.
    if wide(cos) < 0.0 || (wide(sin) < 0.0 && !id.planar()) {
        let one = 1.0 - 1.0 / L::PROBABILITY;
        let want = if wide(sin) < 0.0 {
            [0.0, one]
        } else {
            [one, 0.0]
        };
        assert_eq!([cdf, sf], want, "outside, at {at:?}");
    }
}

/// The tails of a word that is a probability, 1 for what lacks nothing.
fn tails(p: f64) -> [f64; 2] {
    [p, 1.0 - p]
}

fn true_pair(id: Id, lower: f64, upper: f64) -> (f64, f64) {
    match id {
        Id::CosPower(k) => power_pair(k, lower, upper),
        id => Truth::of(id).pair(lower, upper),
    }
}

pub(super) fn warps<L: Law>(law: L, id: Id, word: u32) {
    let p = wide(L::probability(word));
    let [lower, upper] = tails(p);
    for (at, want) in [
        (law.warp(word), true_pair(id, lower, upper)),
        (law.warp_sf(word), true_pair(id, upper, lower)),
    ] {
        assert_unit::<L>(&[at.cos, at.sin], L::LENGTH);
        assert!(
            wide(at.cos) >= 0.0 && (id.planar() || wide(at.sin) >= 0.0),
            "{at:?} at {p}"
        );
        assert_near(wide(at.cos), want.0, PAIR_UNITS, L::COMPONENT, "cos θ");
        assert_near(wide(at.sin), want.1, PAIR_UNITS, L::COMPONENT, "sin θ");
    }
}

pub(super) fn angles<L: Law>(law: L, id: Id, word: u32) {
    let turn = wide(L::turn(word));
    let (pdf, [cdf, sf]) = (law.pdf(word), law.tails(word));
    assert_near(cdf + sf, 1.0, 2.0, L::PROBABILITY, "cdf + sf");
    let inside = turn <= 0.25 && turn >= if id.planar() { -0.25 } else { 0.0 };
    if !inside {
        let one = 1.0 - 1.0 / L::PROBABILITY;
        let want = if turn > 0.0 {
            [0.0, one, 0.0]
        } else {
            [0.0, 0.0, one]
        };
        assert_eq!([pdf, cdf, sf], want, "outside, at {turn}");
        return;
    }
    let (sin, cos) = (turn * TAU).sin_cos();
    if let Id::CosPower(k) = id {
        let cos = if turn == 0.25 { 0.0 } else { cos };
        let want = cos.powf(k + 1.0);
        assert_near(sf, want, POWER_TAIL_UNITS, L::PROBABILITY, "sf");
        let want = (k + 1.0) / TAU * cos.powf(k) * sin;
        // Beside the horizon a unit of the cosine is much of it.
        let of_cosine = if cos > 0.0 {
            k * want * 65536.0 / (cos * L::COMPONENT)
        } else {
            0.0
        };
        let units = POWER_DENSITY_UNITS + 1.5 * of_cosine;
        assert_near(pdf, want, units, 65536.0, "pdf");
    } else {
        let truth = Truth::of(id);
        let [lower, upper] = truth.tails(turn);
        assert_near(cdf, lower, TAIL_UNITS, L::PROBABILITY, "cdf");
        assert_near(sf, upper, TAIL_UNITS, L::PROBABILITY, "sf");
        assert_near(pdf, truth.pdf_at(turn), TAIL_UNITS, L::PROBABILITY, "pdf");
    }
}

pub(super) fn quantiles<L: Law>(law: L, id: Id, word: u32) {
    let [lower, upper] = tails(wide(L::probability(word)));
    let start = if id.planar() { -0.25 } else { 0.0 };
    for (turn, (cos, sin)) in [
        (law.quantile(word), true_pair(id, lower, upper)),
        (law.isf(word), true_pair(id, upper, lower)),
    ] {
        let turn = wide(turn);
        assert!((start..=0.25).contains(&turn), "θ = {turn} at {lower}");
        let want = sin.atan2(cos) / TAU;
        assert_near(turn, want, TURN_UNITS, L::PROBABILITY, "θ");
    }
}

/// Words of a sample, as the table in the documentation of `coslobe::integers` has them.
fn words_of<L: Law>(id: Id) -> usize {
    if let Id::CosPower(_) = id {
        return 3;
    }
    // cos θ is the largest of k + 1 uniform numbers, of half a word each in the short format.
    let k = id.exponent() as usize;
    match (L::SHORT, id.planar()) {
        (false, true) => k + 1,
        (false, false) => k + 2,
        (true, true) => k.max(1),
        (true, false) => (k + 3) / 2,
    }
}

pub(super) fn draws<L: Law>(law: L, id: Id, words: &Words) {
    let mut rng = words.uncounted();
    let d = law.sample(&mut rng);
    assert_eq!(rng.drawn, (words_of::<L>(id), 0), "words drawn");
    let d = d.as_ref();
    assert!(wide(d[1]) > 0.0, "{d:?} is not above the horizon");
    assert_unit::<L>(d, L::LENGTH);
    assert_eq!(law.try_sample(&mut words.clone()).as_ref(), d, "try_sample");
}

pub(super) fn phases<L: Law>(word: u32) {
    let (sin, cos) = (wide(L::turn(word)) * TAU).sin_cos();
    let at = L::cos_sin(word);
    for (got, want) in [(at.cos, cos), (at.sin, sin)] {
        // −1 saturates as 1 does.
        let off = ((wide(got) - want) * L::COMPONENT).abs();
        assert!(off <= 1.5, "{at:?} at {word:#010x}");
    }
}
