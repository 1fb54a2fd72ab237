//! Warps: from probabilities to directions and back.

use super::float::Float;
use super::input::Words;
use super::measure::{assert_close, assert_positive_or_zero, assert_unit, context};
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Lambert, Planar, Spatial, SphereShell};

/// The promise: a unit vector to 2 ulp of 1.
const UNIT_ULP: f64 = 2.0;
/// unwarp_direction(warp_direction(u)) against u in units of 1 + |ln u|, as for `quantiles`, with
/// the length of (x, z) as a further rounding.
const ROUND_TRIP_ULP: f64 = 16.0;
/// The azimuth comes back in turns to so many ulp of 1, round the seam.
const TURN_ULP: f64 = 2.0;
/// Below this many smallest normals, x and z are too short of digits to hold the azimuth.
const SHORT: f64 = 1e3;

/// Words: cdf of θ; azimuth in turns.
pub fn check(data: &[u8]) {
    all::<f32>(Words::new(data));
    all::<f64>(Words::new(data));
}

fn all<T: Float>(mut words: Words) {
    let us = T::both(words.word(), 0.0, 1.0);
    let turns = T::both(words.word(), 0.0, 1.0);
    for (u, turn) in [(us[0], turns[0]), (us[1], turns[1]), (us[0], turns[1])] {
        planar(&Disk, u);
        planar(&CircleShell, u);
        planar(&CircleArc, u);
        spatial(&Ball, u, turn);
        spatial(&SphereShell, u, turn);
        spatial(&Lambert, u, turn);
    }
}

fn domain<T: Float>(u: T) -> bool {
    u.wide() >= 0.0 && u.wide() <= 1.0
}

fn planar<T: Float, L: Planar<T>>(law: &L, u: T) {
    let _context = context::<T, L>();
    pair(law.warp(u), u);
    pair(law.warp_sf(u), u);
    if domain(u) && u.wide() != 0.5 {
        let (sin, mirrored) = (law.warp(u).sin, law.warp_sf(u).sin);
        assert_eq!(sin.word(), (-mirrored).word(), "not odd at u = {u:e}");
        assert_eq!(
            sin.negative(),
            u.wide() < 0.5,
            "the wrong side at u = {u:e}"
        );
    }
}

pub fn spatial<T: Float, L: Spatial<T>>(law: &L, u: T, turn: T) {
    let _context = context::<T, L>();
    for at in [law.warp(u), law.warp_sf(u)] {
        pair(at, u);
        if domain(u) {
            assert_positive_or_zero(at.sin, "sin θ");
        }
    }
    let d = law.warp_direction([u, turn]);
    if !domain(u) || !domain(turn) {
        assert!(d.iter().any(|c| c.nan()), "{d:?} at ({u:e}, {turn:e})");
        return;
    }
    assert_unit(d, UNIT_ULP);
    assert_positive_or_zero(d[1], "cos θ");
    let [back, back_turn] = law.unwarp_direction(d);
    assert!(
        domain(back) && domain(back_turn) && back_turn.wide() < 1.0,
        "{back:e}, {back_turn:e}"
    );
    // Compared at the nearer tail, so that a u near 1 does not hide an error of the other one.
    let (u, back) = if u.wide() <= 0.5 {
        (u.wide(), back.wide())
    } else {
        (1.0 - u.wide(), 1.0 - back.wide())
    };
    let units = 1.0 + u.max(T::SMALLEST).ln().abs();
    let floor = if u == back { 0.0 } else { T::ULP };
    if (u - back).abs() > floor {
        assert_close::<T>(back, u, ROUND_TRIP_ULP * units, "unwarp_direction");
    }
    if d[0].wide().hypot(d[2].wide()) > SHORT * T::NORMAL {
        let apart = (back_turn.wide() - turn.wide()).abs();
        let apart = apart.min(1.0 - apart);
        assert!(
            apart <= TURN_ULP * T::ULP,
            "azimuth {turn:e} came back as {back_turn:e}"
        );
    }
}

fn pair<T: Float>(at: CosSin<T>, u: T) {
    if !domain(u) {
        assert!(at.cos.nan() && at.sin.nan(), "{at:?} at u = {u:e}");
        return;
    }
    assert_unit([at.cos, at.sin], UNIT_ULP);
    assert_positive_or_zero(at.cos, "cos θ");
}
