//! Laws of space.

use crate::input::input;
use crate::subject::{evaluate, moments};
use crate::{Named, Number, Sink, Subject};
use core::marker::PhantomData;
use coslobe::{Frame, Spatial};
use rand_pcg::Pcg32;

struct InSpace<L, T>(L, PhantomData<T>);

/// A spatial law in `T`.
pub fn spatial<L: Spatial<T> + Named, T: Number>(law: L) -> impl Subject {
    InSpace(law, PhantomData::<T>)
}

impl<L: Spatial<T> + Named, T: Number> Subject for InSpace<L, T> {
    const LAW: &'static str = L::ID.name();
    const NUMBER: &'static str = T::NAME;

    #[inline]
    fn sample(&self, rng: &mut Pcg32, sink: &mut impl Sink) {
        let [x, y, z] = Spatial::sample(&self.0, rng);
        sink.take("sin θ cos φ", x.bits());
        sink.take("cos θ", y.bits());
        sink.take("sin θ sin φ", z.bits());
    }

    #[inline]
    fn evaluate(&self, index: u32, sink: &mut impl Sink) {
        if index == 0 {
            moments(&self.0, sink);
        }
        let (law, input) = (&self.0, input(index));
        evaluate(law, &input, sink);
        let (x, y) = (input.x, input.y);
        sink.take("y", y.bits());
        sink.take("pdf_solid_angle(x)", law.pdf_solid_angle(x).bits());
        let d = law.warp_direction([x, y]);
        for c in d {
            sink.take("warp_direction([x, y])", c.bits());
        }
        for c in law.unwarp_direction(if input.hostile { [x, y, x] } else { d }) {
            sink.take("unwarp_direction", c.bits());
        }
        for c in Frame::from_unit(d).to_world([x, y, y]) {
            sink.take("Frame around it", c.bits());
        }
    }
}
