//! Planted faults: laws and worlds that are wrong in one place.

use crate::stage::v;
use coslobe::rand_core::Rng;
use coslobe::{CosPower, CosSin, Lambert, Law};
use shade_core::{AnySpatial, Sampling, Vector};

/// Lambert's law, wrong in one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Spoiled {
    /// Directions are uniform, and their cosine is forgotten.
    CosineDropped,
    /// Directions of cos²θ, weighed as Lambert's.
    WrongExponent,
    /// The density of a sample is twice what it is elsewhere.
    WrongDensity,
    /// Nothing is wrong.
    Sound,
}

type Space = [f64; 3];

impl Sampling<Space> for Spoiled {
    fn draw<R: Rng>(&self, axis: Space, rng: &mut R) -> (Space, CosSin<f64>, f64) {
        let (d, at, _) = match self {
            Spoiled::CosineDropped => CosPower::new(0.0).expect("0").draw(axis, rng),
            Spoiled::WrongExponent => CosPower::new(2.0).expect("2").draw(axis, rng),
            _ => Lambert.draw(axis, rng),
        };
        let times = f64::from(1 + u8::from(*self == Spoiled::WrongDensity));
        (d, at, times * Lambert.density(at))
    }
    fn density_of(&self, axis: Space, d: Space) -> f64 {
        Lambert.density_of(axis, d)
    }
    fn diffuse_weight(&self, _: CosSin<f64>) -> f64 {
        1.0
    }
    fn mean_cos(&self) -> f64 {
        2.0 / 3.0
    }
}

/// Space in which lamps are sampled by the wrong measure: that of a disk of the lamp's radius at
/// its centre, π(R/d)², in place of the cone's solid angle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Askew(pub(crate) Space);

impl Vector for Askew {
    type T = f64;
    type Law = Plain;
    const DIM: usize = 3;
    fn from_fn(f: impl FnMut(usize) -> f64) -> Self {
        Askew(core::array::from_fn(f))
    }
    fn at(&self, i: usize) -> f64 {
        self.0[i]
    }
    fn dot(self, b: Self) -> f64 {
        self.0.dot(b.0)
    }
    fn isotropic_density() -> f64 {
        Space::isotropic_density()
    }
    fn isotropic<R: Rng>(rng: &mut R) -> Self {
        Askew(Space::isotropic(rng))
    }
    fn around<R: Rng>(self, at: CosSin<f64>, rng: &mut R) -> Self {
        Askew(self.0.around(at, rng))
    }
    fn diffuse_density(cos: f64) -> f64 {
        Space::diffuse_density(cos)
    }
    fn cone<R: Rng>(s2: f64, rng: &mut R) -> (CosSin<f64>, f64) {
        (Space::cone(s2, rng).0, 1.0 / (core::f64::consts::PI * s2))
    }
    fn cone_density(s2: f64, cos: f64) -> f64 {
        Space::cone_density(s2, cos)
    }
}

/// Lambert's law in [`Askew`] space.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plain;

impl Sampling<Askew> for Plain {
    fn draw<R: Rng>(&self, axis: Askew, rng: &mut R) -> (Askew, CosSin<f64>, f64) {
        let (d, at, density) = AnySpatial::Lambert.draw(axis.0, rng);
        (Askew(d), at, density)
    }
    fn density_of(&self, axis: Askew, d: Askew) -> f64 {
        Lambert.density_of(axis.0, d.0)
    }
    fn diffuse_weight(&self, _: CosSin<f64>) -> f64 {
        1.0
    }
    fn mean_cos(&self) -> f64 {
        2.0 / 3.0
    }
}

#[test]
fn the_mutants_are_worlds() {
    let x: Askew = v(&[1.0, 0.0, 0.0]);
    assert_eq!(x.dot(x), 1.0);
}
