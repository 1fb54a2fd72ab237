//! The plane's laws by the angle: θ = asin(2u − 1) for `CircleShell`, θ = π(u − ½) for `CircleArc`,
//! then sin and cos of it.

use super::maths::{Libm, Maths, Micro, Std};
use super::{About, flat};
use crate::contender::Contender;
use kit::accuracy::format::Format;
use kit::accuracy::reference::Id;
use rand::distr::{Distribution, StandardUniform};
use std::f64::consts::PI;

pub(super) fn all(list: &mut Vec<Contender>) {
    library::<f32, Std>(list);
    library::<f32, Libm>(list);
    library::<f32, Micro>(list);
    library::<f64, Std>(list);
}

fn library<T: Format, M: Maths<T>>(list: &mut Vec<Contender>)
where
    StandardUniform: Distribution<T>,
{
    let about = |name, short, law| About {
        name,
        short,
        library: M::NAME,
        law,
    };
    let shell = about("asin, then sin and cos", "asin", Id::CircleShell);
    flat::<T, _>(list, shell, |u| {
        let (sin, cos) = M::sin_cos(M::asin(u + u - T::of(1.0)));
        [sin, cos]
    });
    let arc = about("angle, then sin and cos", "angle", Id::CircleArc);
    flat::<T, _>(list, arc, |u| {
        let (sin, cos) = M::sin_cos(T::of(PI) * (u - T::of(0.5)));
        [sin, cos]
    });
}
