//! The shell's law by rejection: a uniform direction of the hemisphere, kept with probability
//! cos²θ.
//!
//! What is left when no inverse is at hand; cos³ has the uniform ball instead.

use super::{About, push};
use crate::contender::{Contender, Measure};
use coslobe::rand_core::Rng;
use kit::accuracy::format::Format;
use kit::accuracy::reference::Id;
use kit::accuracy::wide::Wide;
use kit::study::cell::{Cell, Draw, generator};
use kit::study::errors::{Errors, of_pair, polar};
use rand::RngExt;
use rand::distr::StandardUniform;
use rand::distr::uniform::SampleUniform;
use rand_distr::{Distribution, Uniform, UnitSphere};
use std::marker::PhantomData;

pub(super) fn all(list: &mut Vec<Contender>) {
    format::<f32>(list);
    format::<f64>(list);
}

#[derive(Clone, Copy)]
struct Hemisphere<T>(PhantomData<T>);

impl<T: Format> Draw for Hemisphere<T>
where
    UnitSphere: Distribution<[T; 3]>,
    StandardUniform: Distribution<T>,
{
    type Out = [T; 3];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; 3] {
        loop {
            let [x, z, y] = UnitSphere.sample(rng);
            let v: T = rng.random();
            if v < y * y {
                return [x, if y < T::default() { -y } else { y }, z];
            }
        }
    }
    fn cos(out: &[T; 3]) -> f64 {
        out[1].wide()
    }
}

fn format<T: Format + SampleUniform>(list: &mut Vec<Contender>)
where
    UnitSphere: Distribution<[T; 3]>,
    StandardUniform: Distribution<T>,
{
    let about = About {
        name: "rejection from the hemisphere",
        short: "rejection",
        library: "rand_distr",
        law: Id::SphereShell,
    };
    let sampler = Hemisphere::<T>(PhantomData);
    let measure: Measure = Box::new(move |_, n| {
        let (mut ours, mut theirs) = (generator(), generator());
        let mut errors = Errors::default();
        for _ in 0..u64::from(n) * 256 {
            let got = polar(&sampler.draw(&mut theirs));
            let want = truth::<T, _>(&mut ours);
            let p = want.0.near().powi(3);
            errors.note(p.min(1.0 - p), of_pair(got, want));
        }
        errors
    });
    push::<T>(list, about, "sample", Cell::drawing(sampler), measure);
}

/// The exact direction of the same uniforms, accepted in the format itself.
fn truth<T: Format + SampleUniform, R: Rng>(rng: &mut R) -> (T::Wide, T::Wide)
where
    StandardUniform: Distribution<T>,
{
    let uniform = Uniform::new(T::of(-1.0), T::of(1.0)).expect("an interval");
    let (unit, two) = (T::of(1.0), T::of(2.0));
    loop {
        let (a, b) = (uniform.sample(rng), uniform.sample(rng));
        let sum = a * a + b * b;
        if sum >= unit {
            continue;
        }
        let y = unit - two * sum;
        let v: T = rng.random();
        if v < y * y {
            let w = |x: T| T::Wide::of(x.wide());
            let sum = w(a) * w(a) + w(b) * w(b);
            let one = T::Wide::of(1.0);
            let y = one - (sum + sum);
            let sin = T::Wide::of(2.0) * (sum * (one - sum)).root();
            return (if y < T::Wide::default() { -y } else { y }, sin);
        }
    }
}
