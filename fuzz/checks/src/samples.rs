//! Samplers, fed by any generator.

use super::float::Float;
use super::input::Words;
use super::measure::{assert_unit, context};
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, CosSin, Disk, Fast, Lambert, Planar, Precise, Spatial,
    SphereShell,
};

/// The promise: a unit vector to 2 ulp of 1 (`Fast`: to 2⁻¹²).
const UNIT_ULP: f64 = 2.0;

/// Calls of [next_u32, next_u64] that one draw makes.
pub trait Drawn {
    const PLANAR: [u32; 2];
    const SPATIAL: [u32; 2];
    /// `uniform::unit` and `uniform::tails`.
    const UNIT: [u32; 2];
}

impl Drawn for f32 {
    const PLANAR: [u32; 2] = [0, 1];
    const SPATIAL: [u32; 2] = [1, 1];
    const UNIT: [u32; 2] = [0, 1];
}

impl Drawn for f64 {
    const PLANAR: [u32; 2] = [0, 2];
    const SPATIAL: [u32; 2] = [0, 3];
    const UNIT: [u32; 2] = [0, 2];
}

impl<T: Drawn> Drawn for Precise<T> {
    const PLANAR: [u32; 2] = T::PLANAR;
    const SPATIAL: [u32; 2] = T::SPATIAL;
    const UNIT: [u32; 2] = T::UNIT;
}

impl Drawn for Fast<f32> {
    const PLANAR: [u32; 2] = [1, 0];
    const SPATIAL: [u32; 2] = [2, 0];
    const UNIT: [u32; 2] = [1, 0];
}

/// The whole input is the generator.
pub fn check(data: &[u8]) {
    all::<f32>(data);
    all::<f64>(data);
    all::<Precise<f32>>(data);
    all::<Precise<f64>>(data);
    all::<Fast<f32>>(data);
}

fn all<T: Float + Drawn>(data: &[u8]) {
    planar::<T, _>(&Disk, data);
    planar::<T, _>(&CircleShell, data);
    planar::<T, _>(&CircleArc, data);
    spatial::<T, _>(&Ball, data);
    spatial::<T, _>(&SphereShell, data);
    spatial::<T, _>(&Lambert, data);
    for k in [0.0, 1e-30, 0.5, 20.0, 1e6, T::LARGEST] {
        let law = CosPower::new(T::narrow(k)).expect("a finite exponent ≥ 0");
        spatial(&law, data);
    }
}

/// Draws enough in a row to come round the input, so that every alignment is met.
fn rounds(data: &[u8]) -> usize {
    data.len().clamp(1, 16)
}

fn planar<T: Float + Drawn, L: Planar<T>>(law: &L, data: &[u8]) {
    let _context = context::<T, L>();
    let mut words = Words::new(data);
    for _ in 0..rounds(data) {
        words.drawn = [0; 2];
        let d = Planar::sample(law, &mut words);
        assert_eq!(words.drawn, T::PLANAR, "words drawn");
        assert_unit(d, UNIT_ULP);
        let [sin, cos] = d;
        assert_open(law.density(CosSin { cos, sin }), d, cos);
    }
}

pub fn spatial<T: Float + Drawn, L: Spatial<T>>(law: &L, data: &[u8]) {
    let _context = context::<T, L>();
    let mut words = Words::new(data);
    for _ in 0..rounds(data) {
        words.drawn = [0; 2];
        let d = Spatial::sample(law, &mut words);
        assert_eq!(words.drawn, T::SPATIAL, "words drawn");
        assert_unit(d, UNIT_ULP);
        let [x, cos, z] = d;
        // hypot of squares that may underflow in T: taken in f64, where only T = f64 can.
        let sin = T::narrow(x.wide().hypot(z.wide()));
        assert!(sin.wide() > 0.0, "{d:?} lies on the axis");
        assert_open(law.density(CosSin { cos, sin }), d, cos);
    }
}

/// Inside the open support, with a density that an estimator can divide by.
fn assert_open<T: Float, const N: usize>(density: T, d: [T; N], cos: T) {
    assert!(cos.wide() > 0.0, "{d:?} is not above the horizon");
    let positive = density.wide() > 0.0 && density.wide() < f64::INFINITY;
    assert!(positive, "density {density:?} at {d:?}");
}
