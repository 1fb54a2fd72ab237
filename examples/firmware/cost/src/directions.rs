//! A `Lambert` direction in each number type alone, for comparing how a program is built.

use crate::Meter;
use coslobe::{Fast, Fixed, Fixed16, Lambert};
use fixed::types::{I1F15, I1F31};
use kit::Number;
use rand_xorshift::XorShiftRng;

/// The operations are called as the types.
pub fn every_direction(meter: &mut Meter) {
    meter.law("Lambert");
    float::<f32>(meter);
    float::<Fast<f32>>(meter);
    float::<f64>(meter);
    meter.draw_as::<XorShiftRng, _, _>(
        "Fixed",
        &Fixed(Lambert),
        |law, rng| law.sample(rng),
        |_, _| <[I1F31; 3]>::default(),
    );
    meter.draw_as::<XorShiftRng, _, _>(
        "Fixed16",
        &Fixed16(Lambert),
        |law, rng| law.sample(rng),
        |_, _| <[I1F15; 3]>::default(),
    );
}

fn float<T: Number>(meter: &mut Meter) {
    meter.draw_as::<XorShiftRng, _, _>(
        T::NAME,
        &Lambert,
        |law, rng| law.sample(rng),
        |_, _| [T::of(0.0); 3],
    );
}
