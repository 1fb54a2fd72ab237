//! pdf, cdf and quantile as the textbook's formulas read, in the standard library's functions.

use super::maths::{Maths, Std};
use super::{About, push};
use crate::contender::{Contender, EXPONENT, Measure};
use kit::accuracy::format::Format;
use kit::accuracy::reference::{self, Direction, Id};
use kit::study::cell::Cell;
use kit::study::errors;
use kit::study::inputs::{angles, probabilities};
use std::f64::consts::{FRAC_1_PI, FRAC_2_PI, PI, TAU};

pub(super) fn all(list: &mut Vec<Contender>) {
    format::<f32>(list);
    format::<f64>(list);
}

fn format<T: Format>(list: &mut Vec<Contender>)
where
    Std: Maths<T>,
{
    let c = T::of;
    let cos = |x: T| Std::sin_cos(x).1;
    let one = c(1.0);
    let half = c(0.5);

    pdf::<T>(list, Id::Disk, move |x| c(FRAC_2_PI) * cos(x) * cos(x));
    cdf::<T>(list, Id::Disk, move |x| {
        let (s, k) = Std::sin_cos(x);
        half + (x + s * k) * c(FRAC_1_PI)
    });

    pdf::<T>(list, Id::CircleShell, move |x| cos(x) * half);
    cdf::<T>(list, Id::CircleShell, move |x| {
        (one + Std::sin_cos(x).0) * half
    });
    quantile::<T>(list, Id::CircleShell, move |u| Std::asin(u + u - one));

    pdf::<T>(list, Id::CircleArc, move |_| c(FRAC_1_PI));
    cdf::<T>(list, Id::CircleArc, move |x| half + x * c(FRAC_1_PI));
    quantile::<T>(list, Id::CircleArc, move |u| c(PI) * (u - half));

    let spatial = Id::FIXED.into_iter().filter(|law| !law.planar());
    for law in spatial.chain([Id::CosPower(EXPONENT)]) {
        let k = law.exponent();
        let (n, next) = (c(k), c(k + 1.0));
        let root = c(1.0 / (k + 1.0));
        pdf::<T>(list, law, move |x| {
            let (s, k) = Std::sin_cos(x);
            next / c(TAU) * Std::powf(k, n) * s
        });
        cdf::<T>(list, law, move |x| one - Std::powf(cos(x), next));
        quantile::<T>(list, law, move |u| Std::acos(Std::powf(one - u, root)));
    }
}

fn about(law: Id) -> About {
    About {
        name: "textbook formula",
        short: "textbook",
        library: "std",
        law,
    }
}

fn pdf<T: Format>(list: &mut Vec<Contender>, law: Id, f: impl Fn(T) -> T + Copy + 'static) {
    angle(list, law, "pdf", f, move |theta| {
        reference::pdf(law, &Direction::at_angle(theta.abs()))
    });
}

fn cdf<T: Format>(list: &mut Vec<Contender>, law: Id, f: impl Fn(T) -> T + Copy + 'static) {
    angle(list, law, "cdf", f, move |theta| {
        let (lower, upper) = reference::tails(law, &Direction::at_angle(theta.abs()));
        // A planar law's tails are those at −|θ|.
        if law.planar() && theta > 0.0 {
            upper
        } else {
            lower
        }
    });
}

fn angle<T: Format>(
    list: &mut Vec<Contender>,
    law: Id,
    operation: &'static str,
    f: impl Fn(T) -> T + Copy + 'static,
    want: impl Fn(f64) -> T::Wide + Copy + 'static,
) {
    let inputs = angles::<T>(law.planar());
    let same = inputs.clone();
    let measure: Measure = Box::new(move |_, _| errors::of_angle(&same.counted, f, want));
    push::<T>(list, about(law), operation, Cell::of(&inputs, f), measure);
}

fn quantile<T: Format>(list: &mut Vec<Contender>, law: Id, f: impl Fn(T) -> T + Copy + 'static) {
    let measure: Measure = Box::new(move |_, n| errors::of_quantile::<T>(law, n, f));
    let cell = Cell::of(&probabilities::<T>(), f);
    push::<T>(list, about(law), "quantile", cell, measure);
}
