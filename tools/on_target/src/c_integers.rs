//! What the C program has to print of the laws in integers.

use crate::c_values::{INPUTS, Lines, filled, sixteen};
use coslobe::fixed::{CosPower, FixedLaw};
use coslobe::fixed16::FixedLaw16;
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Fixed, Fixed16, Lambert, SphereShell};
use fixed::types::{I0F16, I0F32, I1F15, I1F31, U0F16, U0F32, U16F16};

/// Its lines.
pub(crate) fn expected(lines: &mut Lines) {
    q31(lines, "disk", Fixed(Disk), U0F32::to_bits);
    q31(lines, "circle_shell", Fixed(CircleShell), U0F32::to_bits);
    q31(lines, "circle_arc", Fixed(CircleArc), U0F32::to_bits);
    q31(lines, "ball", Fixed(Ball), U0F32::to_bits);
    q31(lines, "sphere_shell", Fixed(SphereShell), U0F32::to_bits);
    q31(lines, "lambert", Fixed(Lambert), U0F32::to_bits);
    let lobe = Fixed(CosPower::new(U16F16::from_bits(0x74ccd)));
    q31(lines, "cos_power", lobe, U16F16::to_bits);
    q15(lines, "disk", Fixed16(Disk));
    q15(lines, "circle_shell", Fixed16(CircleShell));
    q15(lines, "circle_arc", Fixed16(CircleArc));
    q15(lines, "ball", Fixed16(Ball));
    q15(lines, "sphere_shell", Fixed16(SphereShell));
    q15(lines, "lambert", Fixed16(Lambert));
}
