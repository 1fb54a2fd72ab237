//! The laws, by name.

use crate::{Number, Subject, planar, spatial};
use coslobe::{Ball, CircleArc, CircleShell, CosPower, Disk, Lambert, SphereShell};

/// All laws, in the order of [`Laws::each`].
pub const LAWS: [&str; 7] = [
    Disk::NAME,
    CircleShell::NAME,
    CircleArc::NAME,
    Ball::NAME,
    SphereShell::NAME,
    Lambert::NAME,
    <CosPower<f32> as Named>::NAME,
];

/// The exponent of `CosPower`, whose logarithm is no round number.
pub const EXPONENT: f64 = 7.3;

/// A law's name.
pub trait Named {
    /// As in the library's documentation.
    const NAME: &'static str;
}

impl Named for Disk {
    const NAME: &'static str = "Disk";
}

impl Named for CircleShell {
    const NAME: &'static str = "CircleShell";
}

impl Named for CircleArc {
    const NAME: &'static str = "CircleArc";
}

impl Named for Ball {
    const NAME: &'static str = "Ball";
}

impl Named for SphereShell {
    const NAME: &'static str = "SphereShell";
}

impl Named for Lambert {
    const NAME: &'static str = "Lambert";
}

impl<T> Named for CosPower<T> {
    const NAME: &'static str = "CosPower";
}

/// Is shown subjects.
pub trait Visitor {
    /// Looks at one.
    fn visit<S: Subject>(&mut self, subject: &S);
}

/// A number type, by the laws in it.
pub trait Laws {
    /// Shows every law; `CosPower` with [`EXPONENT`].
    fn each(visitor: &mut impl Visitor);
}

impl<T: Number> Laws for T {
    fn each(visitor: &mut impl Visitor) {
        visitor.visit(&planar::<_, T>(Disk));
        visitor.visit(&planar::<_, T>(CircleShell));
        visitor.visit(&planar::<_, T>(CircleArc));
        visitor.visit(&spatial::<_, T>(Ball));
        visitor.visit(&spatial::<_, T>(SphereShell));
        visitor.visit(&spatial::<_, T>(Lambert));
        if let Ok(law) = CosPower::new(T::of(EXPONENT)) {
            visitor.visit(&spatial::<_, T>(law));
        }
    }
}
