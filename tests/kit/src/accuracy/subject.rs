//! What is judged: a law in a number type, seen through the type's raw format.

use super::format::Format;
use super::op::{AT_ANGLE, AT_TAIL, Op, name};
use super::values::{On, Values};
use crate::catalogue::one_law;
use crate::{Id, LawVisitor, Number, PlanarLaw, SpatialLaw};
use coslobe::{CosSin, Fast, Law, Precise, Spatial};

/// A law in each number type that there is of a format.
pub trait Tiers: Format {
    fn tiers(id: Id) -> Vec<Subject<Self>>;
}

impl Tiers for f32 {
    fn tiers(id: Id) -> Vec<Subject<f32>> {
        vec![
            Subject::of::<f32>(id),
            Subject::of::<Precise<f32>>(id),
            Subject::of::<Fast<f32>>(id),
        ]
    }
}

impl Tiers for f64 {
    fn tiers(id: Id) -> Vec<Subject<f64>> {
        vec![Subject::of::<f64>(id), Subject::of::<Precise<f64>>(id)]
    }
}

/// A law in a number type.
pub struct Subject<F> {
    pub id: Id,
    /// The number type's name.
    pub tier: &'static str,
    pub solid: bool,
    pub law: Box<dyn Values<F>>,
}

impl<F: Format> Subject<F> {
    /// A law with no solid angle: planar, or with that one operation left out.
    pub fn planar<T: Number<Raw = F>>(id: Id, law: impl Law<T> + Send + Sync + 'static) -> Self {
        Self::on(id, false, law, |_, _| T::default())
    }

    pub fn spatial<T: Number<Raw = F>>(
        id: Id,
        law: impl Spatial<T> + Send + Sync + 'static,
    ) -> Self {
        Self::on(id, true, law, |law, theta| law.pdf_solid_angle(theta))
    }

    fn on<T: Number<Raw = F>, L: Law<T> + Send + Sync + 'static>(
        id: Id,
        solid: bool,
        law: L,
        value: impl Fn(&L, T) -> T + Send + Sync + 'static,
    ) -> Self {
        let law = On::<T, _, _>::new(law, value, id.planar());
        Subject {
            id,
            tier: T::NAME,
            solid,
            law: Box::new(law),
        }
    }

    /// The law in the number type T.
    pub fn of<T: Number<Raw = F>>(id: Id) -> Self {
        let mut found = Found::<F>(None);
        one_law::<T, _>(id, &mut found);
        found.0.expect("a valid exponent")
    }

    /// The laws in all their number types, those of a law side by side: they share its reference.
    pub fn all(ids: &[Id]) -> Vec<Self>
    where
        F: Tiers,
    {
        ids.iter().flat_map(|&id| F::tiers(id)).collect()
    }

    /// The laws in the format's plain number type.
    pub fn plain(ids: &[Id]) -> Vec<Self>
    where
        F: Number<Raw = F>,
    {
        ids.iter().map(|&id| Self::of::<F>(id)).collect()
    }

    /// One operation by the name in the tables, of an angle or a probability.
    pub fn call(&self, operation: &str, x: F) -> F {
        let at = |slots: &[Op]| slots.iter().position(|&op| name(op) == operation);
        if let Some(slot) = at(&AT_TAIL) {
            return self.law.at_tail(x)[slot];
        }
        let slot = at(&AT_ANGLE).unwrap_or_else(|| panic!("unknown operation {operation}"));
        self.law.at_angle(Some(x), CosSin { cos: x, sin: x })[slot]
    }
}

struct Found<F>(Option<Subject<F>>);

impl<F: Format, T: Number<Raw = F>> LawVisitor<T> for Found<F> {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        self.0 = Some(Subject::planar::<T>(id, law));
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        // The exponent that the format holds is the one to judge by.
        let id = match id {
            Id::CosPower(k) => Id::CosPower(T::of(k).wide()),
            id => id,
        };
        self.0 = Some(Subject::spatial::<T>(id, law));
    }
}
