//! By selects and by branches: the same bits.

use super::TailRoot;
use crate::Tails;
use crate::arithmetic::fast::angle::turn_by;
use crate::arithmetic::fast::kepler::{angle_at_tail_by, direction_at_tail_by};
use crate::arithmetic::fast::power::{exp_times_by, ln_by, ln_cos_by, one_minus_exp_by};
use crate::arithmetic::fast::root::{cbrt_by, cube_warp_by, fourth_power_warp_by};

/// Of two ways to compute a number: any NaN is as good as another.
fn same(what: &str, [a, b]: [f32; 2], at: [f32; 2]) {
    let is_same = a.to_bits() == b.to_bits() || a.is_nan() && b.is_nan();
    assert!(
        is_same,
        "{what} at {at:?}: {a:e} by selects, {b:e} by branches"
    );
}

fn all(x: f32, other: f32) {
    let at = [x, other];
    same("ln", [ln_by::<true>(x), ln_by::<false>(x)], at);
    let ln_cos = [ln_cos_by::<true>(x, other), ln_cos_by::<false>(x, other)];
    same("ln_cos", ln_cos, at);
    let exp = [
        exp_times_by::<true>(x, other),
        exp_times_by::<false>(x, other),
    ];
    same("exp_times", exp, at);
    let less = [one_minus_exp_by::<true>(x), one_minus_exp_by::<false>(x)];
    same("one_minus_exp", less, at);
    if x <= super::LARGE {
        same("cbrt", [cbrt_by::<true>(x), cbrt_by::<false>(x)], at);
    }
}

fn tails(p: Tails<f32>) {
    let at = [p.lower(), p.upper()];
    let pair = |(cos, sin): (f32, f32), other: (f32, f32)| {
        same("cos", [cos, other.0], at);
        same("sin", [sin, other.1], at);
    };
    for n in [1.0, 1.5, 21.0, 1e30, f32::MAX] {
        let root = TailRoot::new(n);
        pair(root.by::<true>(p), root.by::<false>(p));
    }
    let [lower, upper] = at;
    pair(
        cube_warp_by::<true>(lower, upper),
        cube_warp_by::<false>(lower, upper),
    );
    pair(
        fourth_power_warp_by::<true>(lower, upper),
        fourth_power_warp_by::<false>(lower, upper),
    );
    pair(turn_by::<true>(lower), turn_by::<false>(lower));
    let (p, _) = p.nearer();
    pair(
        direction_at_tail_by::<true>(p),
        direction_at_tail_by::<false>(p),
    );
    same(
        "angle",
        [angle_at_tail_by::<true>(p), angle_at_tail_by::<false>(p)],
        at,
    );
}

#[test]
fn by_selects_as_by_branches() {
    let ends = [
        0.0,
        f32::from_bits(1),
        f32::MIN_POSITIVE,
        0.5,
        1.0,
        86.0,
        88.0,
    ];
    let ends = ends
        .into_iter()
        .chain([103.3, f32::MAX, f32::INFINITY, f32::NAN]);
    let near = |x: f32| {
        [x.next_down(), x, x.next_up()]
            .into_iter()
            .flat_map(|x| [x, -x])
    };
    let steps = (0..=u32::MAX).step_by(9973).map(f32::from_bits);
    for x in ends.flat_map(near).chain(steps) {
        for other in [0.0, 1e-40, 3e-8, 0.7, 1.0, 1e20, f32::MAX] {
            all(x, other);
        }
        tails(Tails::from_lower(x));
        tails(Tails::from_upper(x));
    }
}
