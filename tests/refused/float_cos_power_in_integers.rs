//! says: is no law in integers of this format
//! says: `coslobe::integers::CosPower` in integers, of `Fixed` alone
//! says: `coslobe::CosPower` is that of floats
use coslobe::{CosPower, Fixed};

fn main() {
    let law = CosPower::new(20.0f32).unwrap();
    let _ = Fixed(law).sample(&mut coslobe::from_fn(|| 7));
}
