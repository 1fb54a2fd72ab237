//! Tails of the laws that make two uniforms of one word: no single run of zeros leads there, so
//! each half is sent to the least interval that holds the tail, and what falls outside is dropped.

use coslobe::rand_core::Rng;
use coslobe::uniform::TailBits;
use coslobe::{Ball, CosSin, Disk, Planar, Spatial, SphereShell};
use kit::batch::{BatchNumber, BatchVisitor, every_batch_number};
use kit::stats::words::pcg;

const COUNT: usize = 50_000;
/// Kolmogorov's λ, passed by chance in 10⁻⁵ of all cases.
const LAMBDA: f64 = 2.47;

/// A word of the leading bits of both.
fn word<T: BatchNumber>(upper: u64, lower: u64) -> TailBits<T> {
    let mut words = match size_of::<T>() {
        4 => vec![upper >> 32 << 32 | lower >> 32],
        _ => vec![lower, upper],
    };
    T::tail_bits(&mut || words.pop().expect("no more words than these"))
}

/// A nearer tail below 2^−`depth`, on the upper side or the lower.
fn tail(is_upper: bool, depth: u32, noise: u64) -> u64 {
    u64::from(is_upper) << 63 | noise >> depth
}

/// An azimuth within 2^−`depth` turns of 0 or ½.
fn flat_azimuth(depth: u32, noise: u64, half: u64) -> u64 {
    (((noise as i64) >> (depth - 1)) as u64).wrapping_add(half << 63)
}

/// Whether the values, from 0 to 1, are uniform.
fn uniform(what: &str, mut values: Vec<f64>) {
    values.sort_by(f64::total_cmp);
    let n = values.len() as f64;
    let off = |(i, &x): (usize, &f64)| (x - i as f64 / n).max((i + 1) as f64 / n - x);
    let worst = values.iter().enumerate().map(off).fold(0.0, f64::max) * n.sqrt();
    assert!(worst < LAMBDA, "{what}: λ = {worst}");
}

fn disk<T: BatchNumber>(e: i32) {
    let what = format!("Disk {} below cos θ = 2^-{e}", T::NAME);
    let mut rng = pcg(&what);
    let edge = 2f64.powi(-e);
    let (mut cubes, mut right) = (Vec::new(), 0);
    while cubes.len() < COUNT {
        let u = tail(true, 2 * e as u32, rng.next_u64());
        let phi = flat_azimuth(e as u32 + 2, rng.next_u64(), rng.next_u64());
        let direction: [T; 2] = Disk.sample_from_bits(word::<T>(u, phi));
        let [sin, cos]: [f64; 2] = direction.map(Into::into);
        if cos < edge {
            cubes.push((cos / edge).powi(3));
            right += usize::from(sin > 0.0);
        }
    }
    let off = (right as f64 - COUNT as f64 / 2.0) / (COUNT as f64 / 4.0).sqrt();
    assert!(off.abs() < 4.4, "{what}: {right} of {COUNT} to the right");
    uniform(&what, cubes);
}

/// The larger of u and the square of v, or of v, is cos²θ: each tail, in cosᵏ⁺¹θ at the horizon and
/// in sin²θ at the axis, with the least interval of v for that.
fn larger<T: BatchNumber>(law: &impl Spatial<T>, k: i32, e: i32) {
    let what = format!("k = {k} {} 2^-{e}", T::NAME);
    let squared = i32::from(k == 2);
    let mut rng = pcg(&what);
    let mut draw = |u: &dyn Fn(u64) -> u64, v: &dyn Fn(u64) -> u64| {
        let bits = word::<T>(u(rng.next_u64()), v(rng.next_u64()));
        let at: CosSin<T> = law.angle_from_bits(bits);
        let both: [f64; 2] = [at.cos, at.sin].map(Into::into);
        both
    };
    let mut all = |u: &dyn Fn(u64) -> u64, v: &dyn Fn(u64) -> u64, f: &dyn Fn([f64; 2]) -> f64| {
        (0..COUNT).map(|_| f(draw(u, v))).collect::<Vec<_>>()
    };
    let low = |depth: i32| move |noise: u64| noise >> depth;
    let high = |noise: u64| !(noise >> e);
    let power = |[cos, _]: [f64; 2]| (cos * 2f64.powi(e)).powi(k + 1);
    uniform(&what, all(&low(2 * e), &low((2 - squared) * e), &power));
    let square = |scale: i32| move |[_, sin]: [f64; 2]| sin * sin * 2f64.powi(scale);
    uniform(&what, all(&high, &|noise| noise, &square(e)));
    uniform(&what, all(&|noise| noise, &high, &square(e - squared)));
}

struct Halves;

impl BatchVisitor for Halves {
    fn number<T: BatchNumber>(&mut self) {
        let depths = match size_of::<T>() {
            4 => &[8, 10, 12][..],
            _ => &[8, 12, 20, 28],
        };
        for &e in depths {
            disk::<T>(e);
            larger::<T>(&SphereShell, 2, e);
            larger::<T>(&Ball, 3, e);
        }
    }
}

#[test]
fn tails_of_halves() {
    every_batch_number(&mut Halves);
}
