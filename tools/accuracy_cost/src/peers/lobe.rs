//! The polar form: cos θ = u^(1/(n+1)), azimuth by sin and cos of 2πv.
//!
//! As in Embree's renderer: for Lambert's law cos θ = √u and sin θ = √(1 − u); for a lobe cosⁿθ a
//! power, and sin θ = √(1 − cos²θ). Beside the power stands the root that a careful author
//! would take: ∛u for cos², the root of the root for cos³.

use super::maths::{Libm, Maths, Micro, Std};
use super::{About, spatial};
use crate::contender::{Contender, EXPONENT};
use kit::accuracy::format::Format;
use kit::accuracy::reference::Id;
use rand::distr::{Distribution, StandardUniform};
use std::f64::consts::TAU;

pub(super) fn all(list: &mut Vec<Contender>) {
    library::<f32, Std>(list);
    library::<f32, Libm>(list);
    library::<f32, Micro>(list);
    library::<f64, Std>(list);
    roots::<f32>(list, f32::cbrt);
    roots::<f64>(list, f64::cbrt);
}

/// Lambert's law from (u, v), as a renderer writes it.
#[inline(always)]
pub(crate) fn polar(u: f32, v: f32) -> [f32; 3] {
    around::<f32, Std>(u.sqrt(), (1.0 - u).sqrt(), v)
}

/// `SphereShell` by the cube root.
#[inline(always)]
pub(crate) fn cube_root(u: f32, v: f32) -> [f32; 3] {
    around::<f32, Std>(u.cbrt(), sine::<f32, Std>(u.cbrt()), v)
}

/// `Ball` by two square roots.
#[inline(always)]
pub(crate) fn two_roots(u: f32, v: f32) -> [f32; 3] {
    let cos = u.sqrt().sqrt();
    around::<f32, Std>(cos, sine::<f32, Std>(cos), v)
}

/// A lobe by the power.
#[inline(always)]
pub(crate) fn power(u: f32, v: f32, n: f32) -> [f32; 3] {
    let cos = u.powf(1.0 / (n + 1.0));
    around::<f32, Std>(cos, sine::<f32, Std>(cos), v)
}

/// [sin θ cos φ, cos θ, sin θ sin φ] at azimuth v.
#[inline(always)]
fn around<T: Format, M: Maths<T>>(cos: T, sin: T, v: T) -> [T; 3] {
    let (s, c) = M::sin_cos(T::of(TAU) * v);
    [sin * c, cos, sin * s]
}

/// sin θ from cos θ.
#[inline(always)]
fn sine<T: Format, M: Maths<T>>(cos: T) -> T {
    let square = T::of(1.0) - cos * cos;
    M::sqrt(if square > T::default() {
        square
    } else {
        T::default()
    })
}

fn library<T: Format, M: Maths<T>>(list: &mut Vec<Contender>)
where
    StandardUniform: Distribution<T>,
{
    let about = About {
        name: "polar form",
        short: "polar",
        library: M::NAME,
        law: Id::Lambert,
    };
    spatial::<T, _>(list, about, |u, v| {
        around::<T, M>(M::sqrt(u), M::sqrt(T::of(1.0) - u), v)
    });
    for (law, n) in [
        (Id::SphereShell, 2.0),
        (Id::Ball, 3.0),
        (Id::CosPower(EXPONENT), EXPONENT),
    ] {
        let about = About {
            name: "cosⁿ by powf",
            short: "powf",
            library: M::NAME,
            law,
        };
        let y = T::of(1.0 / (n + 1.0));
        spatial::<T, _>(list, about, move |u, v| {
            let cos = M::powf(u, y);
            around::<T, M>(cos, sine::<T, M>(cos), v)
        });
    }
}

fn roots<T: Format>(list: &mut Vec<Contender>, cbrt: impl Fn(T) -> T + Copy + 'static)
where
    StandardUniform: Distribution<T>,
    Std: Maths<T>,
{
    let about = |name, short, law| About {
        name,
        short,
        library: "std",
        law,
    };
    let shell = about("cos² by cbrt", "cbrt", Id::SphereShell);
    spatial::<T, _>(list, shell, move |u, v| {
        let cos = cbrt(u);
        around::<T, Std>(cos, sine::<T, Std>(cos), v)
    });
    let ball = about("cos³ by √√u", "√√u", Id::Ball);
    spatial::<T, _>(list, ball, |u, v| {
        let cos = Std::sqrt(Std::sqrt(u));
        around::<T, Std>(cos, sine::<T, Std>(cos), v)
    });
}
