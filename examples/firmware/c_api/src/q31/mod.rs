//! Every law in integers.

pub mod ball;
pub mod circle_arc;
pub mod circle_shell;
pub mod cos_power;
pub mod disk;
pub mod lambert;
pub mod sphere_shell;

use coslobe::CosSin;
use fixed::types::I1F31;

/// A direction by the cosine and sine of its angle from the axis, in units of 2⁻³¹: 1 is 2³¹ − 1.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct CoslobeCosSinQ31 {
    pub cos: i32,
    pub sin: i32,
}

impl From<CosSin<I1F31>> for CoslobeCosSinQ31 {
    fn from(at: CosSin<I1F31>) -> Self {
        CoslobeCosSinQ31 {
            cos: at.cos.to_bits(),
            sin: at.sin.to_bits(),
        }
    }
}

impl From<CoslobeCosSinQ31> for CosSin<I1F31> {
    fn from(at: CoslobeCosSinQ31) -> Self {
        CosSin {
            cos: I1F31::from_bits(at.cos),
            sin: I1F31::from_bits(at.sin),
        }
    }
}
