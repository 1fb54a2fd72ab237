//! `Disk` by a generic root-finder: θ + sin θ cos θ = π(u − ½), Newton's method held in a bracket
//! by bisection.

use super::maths::{Libm, Maths, Std};
use super::{About, flat, push};
use crate::contender::{Contender, Measure};
use kit::accuracy::format::Format;
use kit::accuracy::reference::Id;
use kit::study::cell::Cell;
use kit::study::errors;
use kit::study::inputs::probabilities;
use rand::distr::{Distribution, StandardUniform};
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) fn all(list: &mut Vec<Contender>) {
    library::<f32, Std>(list);
    library::<f32, Libm>(list);
    library::<f64, Std>(list);
}

/// As a textbook writes it: steps until the bracket or the step no longer moves the angle.
pub(super) fn quantile<T: Format, M: Maths<T>>(u: T) -> T {
    let (half, mut theta) = (T::of(0.5), T::default());
    let target = T::of(PI) * (u - half);
    let (mut low, mut high) = (T::of(-FRAC_PI_2), T::of(FRAC_PI_2));
    for _ in 0..100 {
        let (s, c) = M::sin_cos(theta);
        let residual = theta + s * c - target;
        if residual > T::default() {
            high = theta;
        } else {
            low = theta;
        }
        let mut next = theta - residual / (c * c + c * c);
        if !(next > low && next < high) {
            next = half * (low + high);
        }
        if next == theta || residual == T::default() {
            break;
        }
        theta = next;
    }
    theta
}

fn library<T: Format, M: Maths<T>>(list: &mut Vec<Contender>)
where
    StandardUniform: Distribution<T>,
{
    let about = About {
        name: "Newton with bisection",
        short: "Newton",
        library: M::NAME,
        law: Id::Disk,
    };
    flat::<T, _>(list, about, |u| {
        let (sin, cos) = M::sin_cos(quantile::<T, M>(u));
        [sin, cos]
    });
    let measure: Measure = Box::new(|_, n| errors::of_quantile::<T>(Id::Disk, n, quantile::<T, M>));
    let cell = Cell::of(&probabilities::<T>(), quantile::<T, M>);
    push::<T>(list, about, "quantile", cell, measure);
}
