//! says: is not a law in the number type `f32`
//! says: `coslobe::CosPower` that of floats
use coslobe::{Law, integers::CosPower};
use fixed::types::U16F16;

fn main() {
    let _ = Law::<f32>::pdf(&CosPower::new(U16F16::ONE), 0.5);
}
