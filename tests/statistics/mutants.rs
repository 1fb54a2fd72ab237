//! Wrong samplers that the harness has to reject, each by the test that is there for it.

use crate::{in_plane, in_space};
use coslobe::rand_core::Rng;
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, CosSin, Disk, Fast, Lambert, Law, Planar, Spatial,
    uniform,
};
use kit::Number;
use kit::stats::claim::{Claim, Direction};
use kit::stats::harness::{examine, examine_tail};
use kit::stats::words;
use std::f64::consts::TAU;

const MILLION: usize = 1_000_000;
const MUTANT: &str = "mutant";

fn planar<L: Planar<f64>>(name: &str, k: f64, law: L) -> Claim {
    Claim::new(name, true, k, law.moments())
}

fn spatial<T: Number, L: Spatial<T>>(name: &str, k: f64, law: L) -> Claim {
    Claim::new(name, false, k, law.moments())
}

fn from_pair<T: Number>(at: CosSin<T>, azimuth: CosSin<T>) -> Direction {
    in_space([at.sin * azimuth.cos, at.cos, at.sin * azimuth.sin])
}

#[test]
fn exponent_off_by_2_percent_in_space() {
    // The entropy is the score of k, the most powerful statistic: z = 0.02 k/(k+1) √n.
    for (k, n) in [
        (0.5, 2 * MILLION),
        (1.0, MILLION),
        (7.3, MILLION),
        (1e4, MILLION),
    ] {
        let claim = spatial("exponent off", k, CosPower::new(k).unwrap());
        let mutant = CosPower::new(1.02 * k).unwrap();
        let mut rng = words::pcg(MUTANT);
        assert!(examine(&claim, n, || in_space(mutant.sample(&mut rng))).rejects("entropy"));
    }
}

#[test]
fn exponent_off_by_2_percent_in_the_plane() {
    fn check<L: Planar<f64> + Copy>(k: f64, law: L) {
        let claim = planar("exponent off", k, law);
        let mut rng = words::pcg(MUTANT);
        let draw = || loop {
            let [sin, cos] = Planar::sample(&law, &mut rng);
            if uniform::unit::<f64, _>(&mut rng) < cos.powf(0.02 * k) {
                return in_plane([sin, cos]);
            }
        };
        assert!(examine(&claim, 2 * MILLION, draw).rejects("entropy"));
    }
    check(1.0, CircleShell);
}

#[test]
fn arc_for_shell_and_back() {
    let n = 20_000;
    let mut rng = words::pcg(MUTANT);
    let shell = planar("CircleArc as CircleShell", 1.0, CircleShell);
    assert!(examine(&shell, n, || in_plane::<f64>(CircleArc.sample(&mut rng))).rejects("KS theta"));
    let arc = planar("CircleShell as CircleArc", 0.0, CircleArc);
    assert!(examine(&arc, n, || in_plane::<f64>(CircleShell.sample(&mut rng))).rejects("KS theta"));
}

/// The usual uniform of 24 bits, warped from the horizon.
fn on_a_grid<T: Number>(law: impl Law<T>, mut rng: &mut dyn Rng) -> Direction {
    let u = (rng.next_u64() >> 40) as f64 * 0.5f64.powi(24);
    from_pair(law.warp_sf(T::of(u)), uniform::azimuth(&mut rng))
}

fn grid_of_24_bits<T: Number>() {
    let claim = spatial::<T, _>("24 bits as Ball", 3.0, Ball);
    let mut rng = words::pcg(MUTANT);
    assert!(examine(&claim, MILLION, || on_a_grid::<T>(Ball, &mut rng)).rejects("ties"));
    let tail = |depth| {
        let draw = |rng: &mut dyn Rng| on_a_grid::<T>(Ball, rng);
        examine_tail(
            &claim,
            depth,
            20_000,
            |i, word| if i == 0 { word >> depth } else { word },
            draw,
        )
    };
    assert!(tail(20).rejects("upper cells"));
    assert!(tail(24).is_fatal());
}

#[test]
fn grid_of_24_bits_f32() {
    grid_of_24_bits::<f32>();
}

#[test]
fn grid_of_24_bits_f64() {
    grid_of_24_bits::<f64>();
}

/// What a tail of half a word would be: the one grid coarse enough for `Fast`'s own tolerances.
#[test]
fn grid_of_16_bits_fast() {
    let claim = spatial::<Fast<f32>, _>("16 bits as Ball", 3.0, Ball);
    let draw = |mut rng: &mut dyn Rng| {
        let u = f64::from(rng.next_u32() >> 16) * 0.5f64.powi(16);
        from_pair(Ball.warp_sf(Fast::of(u)), uniform::azimuth(&mut rng))
    };
    let mut rng = words::pcg(MUTANT);
    let never_zero = |rng: &mut dyn Rng| loop {
        let d = draw(rng);
        if d[1] > 0.0 {
            return d;
        }
    };
    assert!(examine(&claim, MILLION, || never_zero(&mut rng)).rejects("ties"));
    let tail = |depth| {
        let shape = move |i, word| words::deep_in(32, depth)(i, word >> u64::from(i == 0));
        examine_tail(&claim, depth, 20_000, shape, draw)
    };
    assert!(tail(13).rejects("upper cells"));
    assert!(tail(16).is_fatal());
}

/// No zero, but a floor: what clamping does to the same grid.
#[test]
fn tail_cut_at_2_to_minus_24() {
    let claim = spatial::<f32, _>("cut Ball", 3.0, Ball);
    let cut = |floor: f32| {
        move |mut rng: &mut dyn Rng| {
            let upper = uniform::unit::<f32, _>(&mut rng).max(floor);
            from_pair(Ball.warp_sf(upper), uniform::azimuth(&mut rng))
        }
    };
    let floor = 0.5f32.powi(24);
    let mut rng = words::pcg(MUTANT);
    let draw = cut(floor);
    examine(&claim, MILLION, || draw(&mut rng)).accepted(); // too rare to show without conditions
    let tail = |floor| {
        let shape = |i, word| words::deep(23)(i, if i == 0 { word >> 1 } else { word });
        examine_tail(&claim, 23, 20_000, shape, cut(floor)).rejects("upper cells")
    };
    assert!(tail(floor) && !tail(0.0));
}

#[test]
fn azimuth_without_1_percent() {
    let claim = spatial::<f64, _>("azimuth short", 1.0, Lambert);
    let mut rng = words::pcg(MUTANT);
    let draw = || {
        let phi = TAU * 0.99 * uniform::unit::<f64, _>(&mut rng);
        let (sin, cos) = phi.sin_cos();
        from_pair(
            Lambert.warp_tails(uniform::tails(&mut rng)),
            CosSin { cos, sin },
        )
    };
    let report = examine(&claim, 200_000, draw);
    assert!(report.rejects("KS azimuth"));
    assert!(report.rejects("cells"));
}

#[test]
fn axis_off_by_a_tenth_of_a_degree() {
    let (s, c) = 0.1f64.to_radians().sin_cos();
    let tilt = |[x, y, z]: Direction| [c * x + s * y, c * y - s * x, z];
    let mut rng = words::pcg(MUTANT);
    // z = 0.0017 E[cos θ]/sd(x) √n: 0.0034 √n for the ball, so 8 million for 9.6 standard errors.
    let claim = spatial::<f64, _>("axis off", 3.0, Ball);
    let draw = || tilt(in_space::<f64>(Ball.sample(&mut rng)));
    assert!(examine(&claim, 8 * MILLION, draw).rejects("mean x"));
    let claim = planar("axis off", 2.0, Disk);
    let draw = || tilt(in_plane::<f64>(Disk.sample(&mut rng)));
    assert!(examine(&claim, 4 * MILLION, draw).rejects("mean theta"));
}

#[test]
fn sign_flip_at_the_lower_end() {
    fn check<L: Planar<f64> + Copy>(k: f64, law: L) {
        let claim = planar("sign flip", k, law);
        let draw = |mut rng: &mut dyn Rng| {
            let [sin, cos] = Planar::sample(&law, &mut rng);
            in_plane([if cos < 1e-3 { sin.abs() } else { sin }, cos])
        };
        assert!(examine_tail(&claim, 40, 20_000, words::deep(40), draw).rejects("side"));
    }
    check(0.0, CircleArc);
    check(1.0, CircleShell); // halves.rs has Disk, which draws by halves
    // Without conditions the flip shows when its region is wide enough to be visited.
    let claim = planar("wide sign flip", 1.0, CircleShell);
    let mut rng = words::pcg(MUTANT);
    let draw = || {
        let [sin, cos]: [f64; 2] = CircleShell.sample(&mut rng);
        in_plane([if cos < 0.02 { sin.abs() } else { sin }, cos])
    };
    assert!(examine(&claim, MILLION, draw).rejects("tail cells"));
}
