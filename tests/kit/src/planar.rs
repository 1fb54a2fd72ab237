//! Laws of the plane.

use crate::input::input;
use crate::subject::{evaluate, moments};
use crate::{Named, Number, Sink, Subject};
use core::marker::PhantomData;
use coslobe::Planar;
use rand_pcg::Pcg32;

struct InPlane<L, T>(L, PhantomData<T>);

/// A planar law in `T`.
pub fn planar<L: Planar<T> + Named, T: Number>(law: L) -> impl Subject {
    InPlane(law, PhantomData::<T>)
}

impl<L: Planar<T> + Named, T: Number> Subject for InPlane<L, T> {
    const LAW: &'static str = L::ID.name();
    const NUMBER: &'static str = T::NAME;

    #[inline]
    fn sample(&self, rng: &mut Pcg32, sink: &mut impl Sink) {
        let [sin, cos] = Planar::sample(&self.0, rng);
        sink.take("sin θ", sin.bits());
        sink.take("cos θ", cos.bits());
    }

    #[inline]
    fn evaluate(&self, index: u32, sink: &mut impl Sink) {
        if index == 0 {
            moments(&self.0, sink);
        }
        evaluate(&self.0, &input(index), sink);
    }
}
