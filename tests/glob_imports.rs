//! Glob imports of this crate and of the crate `fixed` stand in one program: no name of the one
//! hides the other's that is used, nor the crate itself.

use coslobe::*;
use fixed::types::*;
use fixed::*;

#[test]
fn they_do_not_clash() {
    let mut rng = from_fn(|| 0x9E37_79B9);
    let ray: [I1F31; 3] = Fixed(Lambert).sample(&mut rng);
    let short: [I1F15; 2] = Fixed16(Disk).sample(&mut rng);
    assert!(ray[1] > 0 && short[1] > 0);
    let lobe: Fixed<integers::CosPower> = Fixed(integers::CosPower::new(U16F16::from_num(20)));
    let density: fixed::FixedU32<types::extra::U16> = lobe.pdf_solid_angle(I0F32::ZERO);
    assert!(density > 3);
    // That of floats bears the name alone.
    assert!(CosPower::new(20.0f32).is_ok());
}
