//! Lambert's law as pbrt draws it: the concentric map of the square to the disk (Shirley and Chiu,
//! 1997), lifted to the hemisphere by cos θ = √(1 − x² − z²).

use super::maths::{Libm, Maths, Micro, Std};
use super::{About, mapped};
use crate::contender::{Contender, Measure};
use kit::accuracy::format::Format;
use kit::accuracy::reference::Id;
use kit::accuracy::wide::Wide;
use kit::study::errors::{Errors, of_pair, polar};
use kit::study::inputs::tails;
use rand::distr::{Distribution, StandardUniform};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

pub(super) fn all(list: &mut Vec<Contender>) {
    library::<f32, Std>(list);
    library::<f32, Libm>(list);
    library::<f32, Micro>(list);
    library::<f64, Std>(list);
}

fn direction<T: Format, M: Maths<T>>(u: T, v: T) -> [T; 3] {
    let (zero, one) = (T::default(), T::of(1.0));
    let (a, b) = (u + u - one, v + v - one);
    if a == zero && b == zero {
        return [zero, one, zero];
    }
    let size = |x: T| if x < zero { -x } else { x };
    let (r, phi) = if size(a) > size(b) {
        (a, T::of(FRAC_PI_4) * (b / a))
    } else {
        (b, T::of(FRAC_PI_2) - T::of(FRAC_PI_4) * (a / b))
    };
    let (s, c) = M::sin_cos(phi);
    let (x, z) = (r * c, r * s);
    let square = one - x * x - z * z;
    [x, M::sqrt(if square > zero { square } else { zero }), z]
}

/// sin θ is the larger of |2u − 1| and |2v − 1|, whose square is the cdf.
fn measure<T: Format, M: Maths<T>>() -> Measure {
    Box::new(|from, n| {
        let (mut errors, one) = (Errors::default(), T::Wide::of(1.0));
        for side in tails::<T>(from, n) {
            for u in [side, T::of(1.0) - side] {
                // ⅗ in one, u in the other: sin θ from 1/5 up; then ½, for smaller ones.
                for v in [0.6, 0.5] {
                    let v = T::of(v);
                    let size = |x: T| {
                        let x = T::Wide::of(x.wide());
                        let a = x + x - one;
                        if a < T::Wide::default() { -a } else { a }
                    };
                    let (a, b) = (size(u), size(v));
                    let sin = if a > b { a } else { b };
                    let square = (one - sin) * (one + sin);
                    let p = (sin * sin).near().min(square.near());
                    if p > 0.0 {
                        let got = polar(&direction::<T, M>(u, v));
                        errors.note(p, of_pair(got, (square.root(), sin)));
                    }
                }
            }
        }
        errors
    })
}

fn library<T: Format, M: Maths<T>>(list: &mut Vec<Contender>)
where
    StandardUniform: Distribution<T>,
{
    let about = About {
        name: "concentric map",
        short: "concentric",
        library: M::NAME,
        law: Id::Lambert,
    };
    mapped::<T, _>(list, about, direction::<T, M>, measure::<T, M>);
}
