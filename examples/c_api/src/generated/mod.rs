//! One number type a file.

mod f32;
mod fast;
mod q15;
mod q31;
