//! Every law in `f32`.

pub mod ball;
pub mod circle_arc;
pub mod circle_shell;
pub mod cos_power;
pub mod disk;
pub mod lambert;
pub mod sphere_shell;

use coslobe::CosSin;

/// A direction by the cosine and sine of its angle from the axis.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct CoslobeCosSinF32 {
    pub cos: f32,
    pub sin: f32,
}

impl From<CosSin<f32>> for CoslobeCosSinF32 {
    fn from(CosSin { cos, sin }: CosSin<f32>) -> Self {
        CoslobeCosSinF32 { cos, sin }
    }
}

impl From<CoslobeCosSinF32> for CosSin<f32> {
    fn from(CoslobeCosSinF32 { cos, sin }: CoslobeCosSinF32) -> Self {
        CosSin { cos, sin }
    }
}
