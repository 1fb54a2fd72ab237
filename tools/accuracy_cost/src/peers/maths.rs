//! The mathematics libraries that peers are built on.

/// The functions that peers call.
pub(super) trait Maths<T>: Copy + 'static {
    const NAME: &'static str;
    fn sqrt(x: T) -> T;
    fn sin_cos(x: T) -> (T, T);
    fn powf(x: T, y: T) -> T;
    fn asin(x: T) -> T;
    fn acos(x: T) -> T;
}

/// The standard library: on a host, the C library's functions.
#[derive(Clone, Copy)]
pub(super) struct Std;
/// The `libm` crate: what firmware calls.
#[derive(Clone, Copy)]
pub(super) struct Libm;
/// The `micromath` crate: approximations for embedded use, in `f32` alone.
#[derive(Clone, Copy)]
pub(super) struct Micro;

impl Maths<f32> for Std {
    const NAME: &'static str = "std";
    fn sqrt(x: f32) -> f32 {
        x.sqrt()
    }
    fn sin_cos(x: f32) -> (f32, f32) {
        x.sin_cos()
    }
    fn powf(x: f32, y: f32) -> f32 {
        x.powf(y)
    }
    fn asin(x: f32) -> f32 {
        x.asin()
    }
    fn acos(x: f32) -> f32 {
        x.acos()
    }
}

impl Maths<f64> for Std {
    const NAME: &'static str = "std";
    fn sqrt(x: f64) -> f64 {
        x.sqrt()
    }
    fn sin_cos(x: f64) -> (f64, f64) {
        x.sin_cos()
    }
    fn powf(x: f64, y: f64) -> f64 {
        x.powf(y)
    }
    fn asin(x: f64) -> f64 {
        x.asin()
    }
    fn acos(x: f64) -> f64 {
        x.acos()
    }
}

impl Maths<f32> for Libm {
    const NAME: &'static str = "libm";
    fn sqrt(x: f32) -> f32 {
        libm::sqrtf(x)
    }
    fn sin_cos(x: f32) -> (f32, f32) {
        libm::sincosf(x)
    }
    fn powf(x: f32, y: f32) -> f32 {
        libm::powf(x, y)
    }
    fn asin(x: f32) -> f32 {
        libm::asinf(x)
    }
    fn acos(x: f32) -> f32 {
        libm::acosf(x)
    }
}

impl Maths<f32> for Micro {
    const NAME: &'static str = "micromath";
    fn sqrt(x: f32) -> f32 {
        micromath::F32Ext::sqrt(x)
    }
    fn sin_cos(x: f32) -> (f32, f32) {
        micromath::F32Ext::sin_cos(x)
    }
    fn powf(x: f32, y: f32) -> f32 {
        micromath::F32Ext::powf(x, y)
    }
    fn asin(x: f32) -> f32 {
        micromath::F32Ext::asin(x)
    }
    fn acos(x: f32) -> f32 {
        micromath::F32Ext::acos(x)
    }
}
