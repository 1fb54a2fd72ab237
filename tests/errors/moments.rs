//! Exact moments against values computed apart (`tools/reference.py`).

use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, Disk, Fast, Lambert, Law, Moments, Precise, Real,
    SphereShell,
};

fn moments<T: Real>(law: &str, round: impl Fn(f64) -> T) -> Moments<T> {
    match law {
        "Disk" => Disk.moments(),
        "CircleShell" => CircleShell.moments(),
        "CircleArc" => CircleArc.moments(),
        "Ball" => Ball.moments(),
        "SphereShell" => SphereShell.moments(),
        "Lambert" => Lambert.moments(),
        power => {
            let k = power
                .strip_prefix("CosPower(")
                .and_then(|k| k.strip_suffix(')'));
            let k = k.and_then(|k| k.parse().ok()).expect("a law of the table");
            CosPower::new(round(k)).expect("a valid exponent").moments()
        }
    }
}

/// The fixed laws' moments are constants, correctly rounded. `CosPower` computes them: its variance
/// of θ is the difference of two sums, its entropy crosses zero, its k is rounded to the format.
fn agrees<T: Real>(epsilon: f64, round: impl Fn(f64) -> T, wide: impl Fn(T) -> f64) {
    let table = include_str!("../reference/moments.csv");
    let mut checked = 0;
    for line in table.lines().filter(|l| !l.starts_with('#')) {
        let cells: Vec<_> = line.split(',').collect();
        let want = f64::from_bits(u64::from_str_radix(cells[2], 16).expect("hex bits"));
        let m = moments(cells[0], &round);
        let got = wide(match cells[1] {
            "mean_cos" => m.mean_cos,
            "var_cos" => m.var_cos,
            "mean_theta" => m.mean_theta,
            "var_theta" => m.var_theta,
            "entropy" => m.entropy,
            other => panic!("unknown moment {other}"),
        });
        if cells[0].starts_with("CosPower") {
            let ulps = if cells[1] == "var_theta" { 16.0 } else { 4.0 };
            let scale = if cells[1] == "entropy" {
                want.abs().max(1.0)
            } else {
                want.abs()
            };
            assert!(
                (got - want).abs() <= ulps * epsilon * scale,
                "{line}: {got:e}, {want:e}"
            );
        } else {
            assert_eq!(got, wide(round(want)), "{line}");
        }
        checked += 1;
    }
    assert_eq!(checked, 70);
}

#[test]
fn f64_moments() {
    agrees(f64::EPSILON, |x| x, |x: f64| x);
    agrees(f64::EPSILON, Precise, |x: Precise<f64>| x.0);
}

#[test]
fn f32_moments() {
    agrees(f64::from(f32::EPSILON), |x| x as f32, f64::from);
    agrees(f64::from(f32::EPSILON), |x| Precise(x as f32), f64::from);
    // By `f32`'s code: moments are no inner loop's business.
    agrees(f64::from(f32::EPSILON), |x| Fast(x as f32), f64::from);
}

/// `CosPower` in `Precise<f32>` too gives the nearest number, where k is one of the format: it computes in
/// `f64`. `Precise<f64>` does so as well, and so has `f64`'s own errors there.
#[test]
fn precise_f32_moments_of_a_lobe_are_the_nearest() {
    let table = include_str!("../reference/moments.csv");
    let mut checked = 0;
    for line in table.lines().filter(|l| l.starts_with("CosPower")) {
        let cells: Vec<_> = line.split(',').collect();
        let k = cells[0]
            .trim_start_matches("CosPower(")
            .trim_end_matches(')');
        let k: f64 = k.parse().expect("an exponent");
        if f64::from(k as f32) != k {
            continue;
        }
        let want = f64::from_bits(u64::from_str_radix(cells[2], 16).expect("hex bits"));
        let m = moments(cells[0], |x| Precise(x as f32));
        let got = match cells[1] {
            "mean_cos" => m.mean_cos,
            "var_cos" => m.var_cos,
            "mean_theta" => m.mean_theta,
            "var_theta" => m.var_theta,
            _ => m.entropy,
        };
        assert_eq!(got.0, want as f32, "{line}");
        checked += 1;
    }
    assert!(checked >= 20, "{checked}");
}

#[test]
fn the_largest_exponents_have_finite_moments() {
    let m = CosPower::new(f64::MAX).expect("finite").moments();
    assert_eq!(m.mean_cos, 1.0);
    assert!(m.mean_theta > 0.0 && m.var_theta >= 0.0 && m.var_cos >= 0.0);
    assert!(m.entropy.is_finite());
}
