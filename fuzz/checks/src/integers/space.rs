//! What laws in space have beside what all have.

use super::format::wide;
use super::line::{assert_near, assert_unit};
use crate::input::{Input, Words};
use coslobe::integers::{Fixed16Spatial, FixedFrame, FixedSpatial};
use coslobe::{Fixed, Fixed16, NormalError, Sample};
use fixed::types::{I1F15, I1F31};
use kit::Id;

/// Two operations that say the same, each with its own rounding.
const SAME_UNITS: f64 = 8.0;
/// A product of two magnitudes, each with its error.
const DIRECTION_UNITS: f64 = 6.0;
/// What `FixedFrame` states for a unit vector turned, and for one turned and back.
const TURNED_UNITS: f64 = 9.0;
const BACK_UNITS: f64 = 14.0;

/// The direction, (cos θ, sin θ) and density of a sample.
pub(super) type Drawn<C> = ([C; 3], [C; 2], f64);

pub(super) trait Law: super::Law<Direction = [<Self as super::Law>::Component; 3]> {
    fn pdf_solid_angle(&self, turn: u32) -> f64;
    fn warp_direction(&self, u: [u32; 2]) -> [Self::Component; 3];
    fn unwarp_direction(&self, d: [Self::Component; 3]) -> [f64; 2];
    fn drawn(&self, words: &mut Words) -> Drawn<Self::Component>;
    fn around(&self, n: [Self::Component; 3], words: &mut Words) -> [Self::Component; 3];
    fn drawn_around(&self, n: [Self::Component; 3], w: &mut Words) -> Drawn<Self::Component>;
    /// A direction to the world and back, around a vector of any length; and what `new` says of it.
    fn turned(n: [Self::Component; 3], d: [Self::Component; 3]) -> Turned<Self::Component>;
}

pub(super) struct Turned<C> {
    checked: Result<(), NormalError>,
    world: [C; 3],
    back: [C; 3],
}

fn parts<C, D: fixed::traits::Fixed>(s: Sample<C, 3, D>) -> Drawn<C> {
    (s.direction, [s.at.cos, s.at.sin], wide(s.density))
}

impl<L: FixedSpatial> Law for Fixed<L> {
    fn pdf_solid_angle(&self, turn: u32) -> f64 {
        wide(self.pdf_solid_angle(<Self as super::Law>::turn(turn)))
    }
    fn warp_direction(&self, u: [u32; 2]) -> [I1F31; 3] {
        self.warp_direction(u.map(<Self as super::Law>::probability))
    }
    fn unwarp_direction(&self, d: [I1F31; 3]) -> [f64; 2] {
        self.unwarp_direction(d).map(wide)
    }
    fn drawn(&self, words: &mut Words) -> Drawn<I1F31> {
        parts(self.sample_with_density(words))
    }
    fn around(&self, n: [I1F31; 3], words: &mut Words) -> [I1F31; 3] {
        self.sample_around(n, words)
    }
    fn drawn_around(&self, n: [I1F31; 3], words: &mut Words) -> Drawn<I1F31> {
        parts(self.sample_around_with_density(n, words))
    }
    fn turned(n: [I1F31; 3], d: [I1F31; 3]) -> Turned<I1F31> {
        let frame = FixedFrame::from_unit(n);
        assert_eq!(frame.normal(), n);
        let world = frame.to_world(d);
        Turned {
            checked: FixedFrame::new(n).map(|checked| assert_eq!(checked, frame)),
            world,
            back: frame.to_local(world),
        }
    }
}

impl<L: Fixed16Spatial> Law for Fixed16<L> {
    fn pdf_solid_angle(&self, turn: u32) -> f64 {
        wide(self.pdf_solid_angle(<Self as super::Law>::turn(turn)))
    }
    fn warp_direction(&self, u: [u32; 2]) -> [I1F15; 3] {
        self.warp_direction(u.map(<Self as super::Law>::probability))
    }
    fn unwarp_direction(&self, d: [I1F15; 3]) -> [f64; 2] {
        self.unwarp_direction(d).map(wide)
    }
    fn drawn(&self, words: &mut Words) -> Drawn<I1F15> {
        parts(self.sample_with_density(words))
    }
    fn around(&self, n: [I1F15; 3], words: &mut Words) -> [I1F15; 3] {
        self.sample_around(n, words)
    }
    fn drawn_around(&self, n: [I1F15; 3], words: &mut Words) -> Drawn<I1F15> {
        parts(self.sample_around_with_density(n, words))
    }
    fn turned(n: [I1F15; 3], d: [I1F15; 3]) -> Turned<I1F15> {
        let frame = FixedFrame::from_unit(n);
        assert_eq!(frame.normal(), n);
        let world = frame.to_world(d);
        Turned {
            checked: FixedFrame::new(n).map(|checked| assert_eq!(checked, frame)),
            world,
            back: frame.to_local(world),
        }
    }
}

/// The pair of `warp`, turned about the axis; its way back.
pub(super) fn directions<L: Law>(law: L, id: Id, input: &mut Input) {
    let u = [input.words.word() as u32, input.words.word() as u32];
    let (d, at) = (law.warp_direction(u), law.warp(u[0]));
    assert_unit::<L>(&d, DIRECTION_UNITS);
    assert_eq!(d[1], at.cos, "cos θ");
    let phase = L::cos_sin(u[1]);
    for (part, along) in [(d[0], phase.cos), (d[2], phase.sin)] {
        let want = wide(at.sin) * wide(along);
        assert_near(
            wide(part),
            want,
            2.5,
            L::COMPONENT,
            "sin θ times the azimuth",
        );
    }
    let [lower, turn] = law.unwarp_direction(d);
    let [want, _] = law.unwarps(at);
    // What x and z round of sin θ, an exponent multiplies.
    let (sin, units) = (wide(at.sin), SAME_UNITS * (id.exponent() + 1.0));
    assert_near(lower, want, units, L::PROBABILITY, "cdf of the direction");
    let apart = (turn - wide(L::probability(u[1]))).abs();
    let apart = apart.min(1.0 - apart) * sin * std::f64::consts::TAU;
    assert!(
        apart * L::COMPONENT <= SAME_UNITS,
        "azimuth of {u:?} came back as {turn}"
    );
}

/// Of any three words.
pub(super) fn back<L: Law>(law: L, input: &mut Input) {
    let d = [(); 3].map(|()| L::component(input.words.word()));
    let [_, turn] = law.unwarp_direction(d);
    let [x, _, z] = d.map(wide);
    if (x, z) == (0.0, 0.0) {
        assert_eq!(turn, 0.0, "the azimuth on the axis");
    } else {
        let want = z.atan2(x) / std::f64::consts::TAU;
        let apart = (turn - want).rem_euclid(1.0);
        let apart = apart.min(1.0 - apart) * L::PROBABILITY;
        assert!(
            apart <= SAME_UNITS,
            "azimuth {turn} of {d:?}: {apart} units"
        );
    }
}

fn assert_drawn<L: Law>(law: L, (d, [cos, sin], density): Drawn<L::Component>) {
    let open = wide(cos) > 0.0 && wide(sin) >= 0.0 && density > 0.0;
    assert!(open, "({cos}, {sin}), {density} of {d:?}");
    assert_unit::<L>(&[cos, sin], L::LENGTH);
    assert_eq!(density, law.density(coslobe::CosSin { cos, sin }));
}

/// With its density.
pub(super) fn draws<L: Law>(law: L, words: &Words) {
    let s = law.drawn(&mut words.clone());
    assert_eq!(s.0, law.sample(&mut words.clone()), "sample_with_density");
    assert_eq!(s.0[1], s.1[0], "cos θ");
    assert_drawn(law, s);
}

/// Around a vector of any length, or one of unit length.
pub(super) fn around<L: Law>(law: L, input: &mut Input) {
    let n = if input.flag() {
        law.warp_direction([input.words.word() as u32, input.words.word() as u32])
    } else {
        [(); 3].map(|()| L::component(input.words.word()))
    };
    let n = if input.flag() { [n[0], n[2], n[1]] } else { n };
    let s = law.drawn(&mut input.words.clone());
    let t = L::turned(n, s.0);
    // −1 is read as one unit more.
    let squares = n.map(|c| wide(c).max(-1.0 + 1.0 / L::COMPONENT).powi(2));
    let length = squares.iter().sum::<f64>().sqrt();
    let slack = if L::SHORT {
        2f64.powi(-12)
    } else {
        2f64.powi(-20)
    };
    let off = (length - 1.0).abs();
    if off < 0.9 * slack {
        assert_eq!(t.checked, Ok(()), "{n:?} has length {length}");
    } else if off > 1.1 * slack {
        assert!(t.checked.is_err(), "{n:?} has length {length}");
    }
    if off * L::COMPONENT <= 4.0 {
        assert_unit::<L>(&t.world, TURNED_UNITS);
        for (got, want) in t.back.into_iter().zip(s.0) {
            assert_near(
                wide(got),
                wide(want),
                BACK_UNITS,
                L::COMPONENT,
                "the way back",
            );
        }
    }
    let around = law.around(n, &mut input.words.clone());
    assert_eq!(around, t.world, "sample_around");
    let drawn = law.drawn_around(n, &mut input.words.clone());
    assert_eq!(drawn, (t.world, s.1, s.2), "sample_around_with_density");
}

/// The density at the pair of an angle; 0 outside the support.
pub(super) fn solid_angle<L: Law>(law: L, input: &mut Input) {
    let word = input.words.word() as u32;
    let (p, turn) = (law.pdf_solid_angle(word), wide(L::turn(word)));
    if !(0.0..=0.25).contains(&turn) {
        assert_eq!(p, 0.0, "outside, at {turn}");
    } else if turn < 0.25 {
        assert!(p > 0.0, "inside, at {turn}");
        let units = if L::SHORT { 2.0 } else { 0.0 }; // of the pair's rounding
        let want = law.density(L::cos_sin(word));
        assert_near(p, want, units, L::PROBABILITY, "pdf_solid_angle");
    }
}
