//! A point of `rand_distr` plus the normal, normalised: the direction of a uniform point of the
//! disk, circle, ball or sphere that touches the origin.
//!
//! UnitSphere gives Lambert's law, UnitBall `Ball`, UnitDisc `Disk`, UnitCircle `CircleArc`. The
//! shells have no such point: their measure is not uniform.

use super::maths::{Maths, Std};
use super::{About, push};
use crate::contender::{Contender, Measure};
use coslobe::rand_core::Rng;
use kit::accuracy::format::Format;
use kit::accuracy::reference::Id;
use kit::accuracy::wide::Wide;
use kit::study::cell::{Cell, Draw, generator};
use kit::study::errors::{Errors, of_pair, polar};
use rand::distr::uniform::SampleUniform;
use rand_distr::{Distribution, Uniform, UnitBall, UnitCircle, UnitDisc, UnitSphere};
use std::marker::PhantomData;

pub(super) fn all(list: &mut Vec<Contender>) {
    format::<f32>(list);
    format::<f64>(list);
}

fn format<T: Format + SampleUniform>(list: &mut Vec<Contender>)
where
    Std: Maths<T>,
    UnitSphere: Distribution<[T; 3]>,
    UnitBall: Distribution<[T; 3]>,
    UnitDisc: Distribution<[T; 2]>,
    UnitCircle: Distribution<[T; 2]>,
{
    add::<T, _, 3>(list, Id::Lambert, "UnitSphere", UnitSphere);
    add::<T, _, 3>(list, Id::Ball, "UnitBall", UnitBall);
    add::<T, _, 2>(list, Id::Disk, "UnitDisc", UnitDisc);
    add::<T, _, 2>(list, Id::CircleArc, "UnitCircle", UnitCircle);
}

/// The axis is the second component in space, as the laws have it, and in the plane too.
#[derive(Clone, Copy)]
struct Tangent<T, D, const N: usize>(D, PhantomData<[T; N]>);

impl<T, D, const N: usize> Draw for Tangent<T, D, N>
where
    T: Format,
    Std: Maths<T>,
    D: Distribution<[T; N]> + Copy + 'static,
    [T; N]: Default,
{
    type Out = [T; N];
    #[inline(always)]
    fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> [T; N] {
        let mut d = self.0.sample(rng);
        d[1] = d[1] + T::of(1.0);
        let square = d.iter().fold(T::default(), |sum, &x| sum + x * x);
        let length = Std::sqrt(square);
        d.map(|x| x / length)
    }
    fn cos(out: &[T; N]) -> f64 {
        out[1].wide()
    }
}

fn add<T, D, const N: usize>(list: &mut Vec<Contender>, law: Id, name: &'static str, source: D)
where
    T: Format + SampleUniform,
    Std: Maths<T>,
    D: Distribution<[T; N]> + Copy + 'static,
    [T; N]: Default,
{
    let sampler = Tangent(source, PhantomData::<[T; N]>);
    let about = About {
        name: match name {
            "UnitSphere" => "UnitSphere + normal",
            "UnitBall" => "UnitBall + normal",
            "UnitDisc" => "UnitDisc + normal",
            _ => "UnitCircle + normal",
        },
        short: name,
        library: "rand_distr",
        law,
    };
    // No map from a uniform to the direction: judged by its own draws, each against the true
    // direction of the same uniforms.
    let measure: Measure = Box::new(move |_, n| {
        let (mut ours, mut theirs) = (generator(), generator());
        let mut errors = Errors::default();
        for _ in 0..u64::from(n) * 256 {
            let got = polar(&sampler.draw(&mut theirs));
            let (cos, sin) = truth::<T, _>(law, &mut ours);
            // The tail of the surface, arc or volume that lies nearer to the horizon.
            let p = cos.near() * cos.near();
            errors.note(p.min(1.0 - p), of_pair(got, (cos, sin)));
        }
        errors
    });
    push::<T>(list, about, "sample", Cell::drawing(sampler), measure);
}

/// (cos θ, sin θ) of the exact point that the same uniforms stand for. Candidates are accepted as
/// `rand_distr` documents it, in the format itself, so that both walk the same words.
fn truth<T: Format + SampleUniform, R: Rng>(law: Id, rng: &mut R) -> (T::Wide, T::Wide) {
    let uniform = Uniform::new(T::of(-1.0), T::of(1.0)).expect("an interval");
    let (one, two) = (T::Wide::of(1.0), T::Wide::of(2.0));
    let w = |x: T| T::Wide::of(x.wide());
    loop {
        let (a, b) = (uniform.sample(rng), uniform.sample(rng));
        let plane = a * a + b * b;
        let (x, y, z) = (w(a), w(b), T::Wide::default());
        let point = match law {
            Id::Ball => {
                let c = uniform.sample(rng);
                (plane + c * c <= T::of(1.0)).then(|| [x, y, w(c)])
            }
            Id::Disk => (plane <= T::of(1.0)).then_some([x, y, z]),
            _ if plane >= T::of(1.0) => None,
            Id::CircleArc => {
                let sum = x * x + y * y;
                Some([(x * x - y * y) / sum, two * x * y / sum, z])
            }
            _ => {
                let sum = x * x + y * y;
                let factor = two * (one - sum).root();
                Some([x * factor, y * factor, one - two * sum])
            }
        };
        if let Some([x, y, z]) = point {
            let y = y + one;
            let across = if matches!(law, Id::Disk | Id::CircleArc) {
                x
            } else {
                (x * x + z * z).root()
            };
            let length = (x * x + y * y + z * z).root();
            return (y / length, across / length);
        }
    }
}
