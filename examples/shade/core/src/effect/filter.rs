//! Antialiasing: a box filter over the pixel.

use crate::scalar::{half, int};
use crate::{Camera, Effect, Meter, Number, Place, Stream, Vector};
use coslobe::rand_core::Rng;

/// A point of the pixel (x, y) relative to its centre, in pixels. One word: 16 bits a coordinate
/// are 65 536 places, and no place is met twice as often as another.
#[inline(always)]
pub fn through_pixel<V: Vector, M: Meter>(
    camera: &Camera<V>,
    place: Place,
    meter: &mut M,
) -> [V::T; 2] {
    meter.run(Effect::Filter);
    let word = Stream::new(place, 0, Effect::Filter, 0, meter).next_u32();
    let part = |n: u32| {
        let n: V::T = int::<V::T>(n as u16 as i16) + half();
        n * V::T::from_f32(1.0 / 65536.0) * camera.filter
    };
    [part(word), part(word >> 16)]
}
