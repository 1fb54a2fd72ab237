//! What the `Precise` types do with NaN, ∞, signed zeros and arguments outside the support: what
//! the plain types do, to 16 places.

use coslobe::{CosSin, Law, Precise, Spatial};
use kit::catalogue::every_law;
use kit::{Format, Id, LawVisitor, Number, PlanarLaw, SpatialLaw};

/// Its place in the format's order, −0 beside +0; `None` for NaN.
fn place<T: Number>(x: T) -> Option<i64> {
    let top = 1u64 << (8 * size_of::<T>() - 1);
    let size = (x.bits() & (top - 1)) as i64;
    (!x.nan()).then_some(if x.wide() < 0.0 { -size } else { size })
}

fn is_negative_zero<T: Number>(x: T) -> bool {
    x.wide() == 0.0 && x.negative()
}

const EXPONENTS: [f64; 9] = [0.0, 1e-310, 1e-30, 0.5, 1.0, 7.3, 1e4, 1e12, f64::MAX];

/// One input of every kind: a number, and a direction as (cos θ, sin θ).
#[derive(Clone, Copy, Debug)]
struct Input {
    x: f64,
    at: (f64, f64),
}

/// Every operation of every law, by name.
fn all<T: Number>(input: Input) -> Vec<(String, T)> {
    let mut all = All {
        out: Vec::new(),
        input,
    };
    // The largest exponent of each format.
    every_law::<T>(&mut all, &EXPONENTS.map(|k| k.min(T::LARGEST.wide())));
    all.out
}

struct All<T> {
    out: Vec<(String, T)>,
    input: Input,
}

impl<T: Number> LawVisitor<T> for All<T> {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        planar(&mut self.out, &id.to_string(), &law, self.input);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        spatial(&mut self.out, &id.to_string(), &law, self.input);
    }
}

fn planar<T: Number>(out: &mut Vec<(String, T)>, name: &str, law: &impl Law<T>, input: Input) {
    let x = T::of(input.x);
    let at = CosSin {
        cos: T::of(input.at.0),
        sin: T::of(input.at.1),
    };
    let (warp, warp_sf) = (law.warp(x), law.warp_sf(x));
    for (operation, value) in [
        ("pdf", law.pdf(x)),
        ("ln_pdf", law.ln_pdf(x)),
        ("cdf", law.cdf(x)),
        ("sf", law.sf(x)),
        ("warp: cos", warp.cos),
        ("warp: sin", warp.sin),
        ("warp_sf: cos", warp_sf.cos),
        ("warp_sf: sin", warp_sf.sin),
        ("quantile", law.quantile(x)),
        ("isf", law.isf(x)),
        ("density", law.density(at)),
        ("unwarp", law.unwarp(at)),
        ("unwarp_sf", law.unwarp_sf(at)),
        ("lambert_weight", law.lambert_weight(at)),
    ] {
        out.push((format!("{name} {operation}"), value));
    }
}

fn spatial<T: Number>(out: &mut Vec<(String, T)>, name: &str, law: &impl Spatial<T>, input: Input) {
    planar(out, name, law, input);
    let x = T::of(input.x);
    out.push((format!("{name} pdf_solid_angle"), law.pdf_solid_angle(x)));
    let [cos, sin] = [input.at.0, input.at.1].map(T::of);
    let directions = [
        law.warp_direction([T::of(0.5), x]),
        law.warp_direction([x, T::of(0.0)]),
    ];
    let turns = [[sin, cos, T::of(0.0)], [T::of(-0.0), cos, sin]].map(|d| law.unwarp_direction(d));
    let found = directions.into_iter().flatten();
    for value in found.chain(turns.into_iter().flatten()) {
        out.push((format!("{name} direction"), value));
    }
}

fn alike<T: Format>()
where
    Precise<T>: Number,
{
    let pairs = DIRECTIONS.iter().map(|&at| Input { x: 0.5, at });
    let numbers = NUMBERS.iter().map(|&x| Input { x, at: (0.6, 0.8) });
    for input in numbers.chain(pairs) {
        let plain = all::<T>(input);
        for ((name, a), (_, b)) in plain.into_iter().zip(all::<Precise<T>>(input)) {
            let near = match (place(a), place(b)) {
                (Some(a), Some(b)) => (a - b).abs() <= 16,
                (a, b) => a == b,
            };
            assert!(
                near && is_negative_zero(a) == is_negative_zero(b),
                "{name} at {input:?}: {a:?} and {b:?}"
            );
        }
    }
}

const NUMBERS: [f64; 25] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    0.25,
    0.5,
    1.0,
    -0.5,
    -1.0,
    2.0,
    -2.0,
    1.0 + f64::EPSILON,
    5e-324,
    -5e-324,
    1e-310,
    -1e-310,
    1e-45,
    -1e-45,
    1e300,
    -1e300,
    std::f64::consts::FRAC_PI_2,
    -std::f64::consts::FRAC_PI_2,
    1.5707963267948968,
    1.5707962,
];

const DIRECTIONS: [(f64, f64); 27] = [
    (1.0, 0.0),
    (1.0, -0.0),
    (-1.0, 0.0),
    (0.0, 1.0),
    (-0.0, 1.0),
    (0.0, -1.0),
    (-0.0, -1.0),
    (0.6, 0.8),
    (0.6, -0.8),
    (-0.6, 0.8),
    (-0.6, -0.8),
    (1.0, 5e-324),
    (1.0, -5e-324),
    (-1.0, 5e-324),
    (5e-324, 1.0),
    (5e-324, -1.0),
    (-5e-324, 1.0),
    (1e-45, 1.0),
    (1.0, 1e-45),
    (1.0, -1e-45),
    (f64::NAN, 0.0),
    (f64::NAN, 1.0),
    (0.0, f64::NAN),
    (1.0, f64::NAN),
    (-0.6, f64::NAN),
    (-1e-38, f64::NAN),
    (f64::NAN, -0.6),
];

#[test]
fn precise_f64_means_what_f64_means() {
    alike::<f64>();
}

#[test]
fn precise_f32_means_what_f32_means() {
    alike::<f32>();
}
