//! says: is no law in integers of this format
//! says: in integers, of `Fixed` alone
use coslobe::{Fixed16, integers::CosPower};
use fixed::types::U16F16;

fn main() {
    let _ = Fixed16(CosPower::new(U16F16::ONE));
}
