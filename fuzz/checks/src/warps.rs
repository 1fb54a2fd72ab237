//! Warps: from probabilities to directions and back.

use super::input::Input;
use super::measure::{assert_close, assert_positive_or_zero, assert_unit, context};
use coslobe::{CosSin, Planar, Spatial};
use kit::catalogue::one_law;
use kit::{Id, LawVisitor, Number, PlanarLaw, SpatialLaw};

/// The promise: a unit vector to 2 ulp of 1.
const UNIT_ULP: f64 = 2.0;
/// unwarp_direction(warp_direction(u)) against u in units of 1 + |ln u|, as for `quantiles`, with
/// the length of (x, z) as a further rounding.
const ROUND_TRIP_ULP: f64 = 16.0;
/// The azimuth comes back in turns to so many ulp of 1, round the seam.
const TURN_ULP: f64 = 2.0;
/// Below this many smallest normals, x and z are too short of digits to hold the azimuth.
const SHORT: f64 = 1e3;

/// At a probability and an azimuth, and back.
pub(super) fn directions<T: Number>(mut input: Input) {
    let law = input.law::<T>();
    let (u, turn) = (input.number::<T>(0.0, 1.0), input.number(0.0, 1.0));
    one_law(law, &mut Warped { u, turn });
}

/// Of any three numbers.
pub(super) fn back<T: Number>(mut input: Input) {
    let law = input.law::<T>();
    let d: [T; 3] = std::array::from_fn(|_| input.number(-1.0, 1.0));
    one_law(law, &mut Back(d));
}

struct Back<T>([T; 3]);

impl<T: Number> LawVisitor<T> for Back<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, _: L) {}
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        azimuth(&law, self.0);
    }
}

struct Warped<T> {
    u: T,
    turn: T,
}

impl<T: Number> LawVisitor<T> for Warped<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        planar(&law, self.u);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        spatial(&law, self.u, self.turn);
    }
}

fn domain<T: Number>(u: T) -> bool {
    u.wide() >= 0.0 && u.wide() <= 1.0
}

fn planar<T: Number, L: Planar<T>>(law: &L, u: T) {
    let _context = context::<T, L>();
    pair(law.warp(u), u);
    pair(law.warp_sf(u), u);
    if domain(u) && u.wide() != 0.5 {
        let (sin, mirrored) = (law.warp(u).sin, law.warp_sf(u).sin);
        assert_eq!(sin.bits(), (-mirrored).bits(), "not odd at u = {u:?}");
        assert_eq!(
            sin.negative(),
            u.wide() < 0.5,
            "the wrong side at u = {u:?}"
        );
    }
}

fn spatial<T: Number, L: Spatial<T>>(law: &L, u: T, turn: T) {
    let _context = context::<T, L>();
    for at in [law.warp(u), law.warp_sf(u)] {
        pair(at, u);
        if domain(u) {
            assert_positive_or_zero(at.sin, "sin θ");
        }
    }
    let d = law.warp_direction([u, turn]);
    if !domain(u) || !domain(turn) {
        assert!(d.iter().any(|c| c.nan()), "{d:?} at ({u:?}, {turn:?})");
        return;
    }
    assert_unit(d, UNIT_ULP);
    assert_positive_or_zero(d[1], "cos θ");
    let [back, back_turn] = law.unwarp_direction(d);
    assert!(
        domain(back) && domain(back_turn) && back_turn.wide() < 1.0,
        "{back:?}, {back_turn:?}"
    );
    let long = d[0].wide().hypot(d[2].wide()) > SHORT * T::SMALLEST.wide();
    // The nearer tail holds the digits; a number near 1 holds the farther one to an ulp of 1 only.
    let nearer = u.wide().min(1.0 - u.wide());
    let units = ROUND_TRIP_ULP * (1.0 + nearer.max(T::LEAST_STEP).ln().abs());
    if u.wide() > 0.5 {
        let slack = T::ULP * (1.0 + units * nearer);
        let apart = (u.wide() - back.wide()).abs();
        assert!(apart <= slack, "{u:?} came back as {back:?}");
    } else if long {
        assert_close::<T>(back.wide(), u.wide(), units, "unwarp_direction");
    }
    if long {
        let apart = (back_turn.wide() - turn.wide()).abs();
        let apart = apart.min(1.0 - apart);
        assert!(
            apart <= TURN_ULP * T::ULP,
            "azimuth {turn:?} came back as {back_turn:?}"
        );
    }
}

/// The azimuth of any direction, of unit length or not, is in [0, 1).
fn azimuth<T: Number, L: Spatial<T>>(law: &L, d: [T; 3]) {
    let _context = context::<T, L>();
    let [_, turn] = law.unwarp_direction(d);
    if d.iter().any(|c| c.nan()) {
        assert!(d[1].nan() || turn.nan(), "{d:?} gives {turn:?}");
        return;
    }
    assert_positive_or_zero(turn, "azimuth");
    assert!(turn.wide() < 1.0, "azimuth {turn:?} of {d:?}");
}

fn pair<T: Number>(at: CosSin<T>, u: T) {
    if !domain(u) {
        assert!(at.cos.nan() && at.sin.nan(), "{at:?} at u = {u:?}");
        return;
    }
    assert_unit([at.cos, at.sin], UNIT_ULP);
    assert_positive_or_zero(at.cos, "cos θ");
}
