//! Exact moments against values computed apart (`tools/reference.py`).

use coslobe::{CosPower, Law, Moments, Precise};
use kit::catalogue::{self, every_number};
use kit::{Id, Number, NumberVisitor};

fn moments<T: Number>(law: &str) -> Moments<T> {
    let law = Id::parse(law).expect("a law of the table");
    catalogue::moments(law).expect("a valid exponent")
}

/// The fixed laws' moments are constants, correctly rounded. `CosPower` computes them: its variance
/// of θ is the difference of two sums, its entropy crosses zero, its k is rounded to the format.
fn agrees<T: Number>() {
    let table = include_str!("../reference/moments.csv");
    let mut checked = 0;
    for line in table.lines().filter(|l| !l.starts_with('#')) {
        let cells: Vec<_> = line.split(',').collect();
        let want = f64::from_bits(u64::from_str_radix(cells[2], 16).expect("hex bits"));
        let m = moments::<T>(cells[0]);
        let got = T::wide(match cells[1] {
            "mean_cos" => m.mean_cos,
            "var_cos" => m.var_cos,
            "mean_theta" => m.mean_theta,
            "var_theta" => m.var_theta,
            "entropy" => m.entropy,
            other => panic!("unknown moment {other}"),
        });
        if cells[0].starts_with("CosPower") {
            let scale = if cells[1] == "entropy" {
                want.abs().max(1.0)
            } else {
                want.abs()
            };
            assert!(
                (got - want).abs() <= 4.0 * T::EPSILON * scale,
                "{line}: {got:e}, {want:e}"
            );
        } else {
            assert_eq!(got, T::of(want).wide(), "{line}");
        }
        checked += 1;
    }
    assert_eq!(checked, 380);
}

struct Agree;

impl NumberVisitor for Agree {
    fn number<T: Number>(&mut self) {
        agrees::<T>();
    }
}

#[test]
fn moments_in_every_number_type() {
    every_number(&mut Agree);
}

/// `CosPower` in `Precise<f32>` too gives the nearest number, where k is one of the format: it
/// computes in `f64`. `Precise<f64>` does so as well, and so has `f64`'s own errors there.
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
        let m = moments::<Precise<f32>>(cells[0]);
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
