//! The laws of a number type, by what can be hashed of them.

use crate::catalogue::{EXPONENT, Id, LawVisitor, PlanarLaw, SpatialLaw, every_law};
use crate::{Number, Subject, planar, spatial};

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
        every_law::<T>(&mut Subjects(visitor), &[EXPONENT]);
    }
}

struct Subjects<'a, V>(&'a mut V);

impl<T: Number, V: Visitor> LawVisitor<T> for Subjects<'_, V> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        self.0.visit(&planar::<_, T>(law));
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        self.0.visit(&spatial::<_, T>(law));
    }
}
