//! A sample's cosine and density are those of the angle drawn, whatever a rotation rounds away.

use coslobe::rand_core::{Rng, SeedableRng, TryRng};
use coslobe::{Planar, Sample, Spatial};
use kit::Number;
use kit::accuracy::format::Format;
use kit::accuracy::wide::Wide;
use kit::catalogue::{every_law, every_number};
use kit::{Id, LawVisitor, NumberVisitor, PlanarLaw, SpatialLaw};
use rand_pcg::Pcg64;
use std::convert::Infallible;

/// A generator that gives one word again and again.
struct Stuck(u64);

impl TryRng for Stuck {
    type Error = Infallible;
    fn try_next_u32(&mut self) -> Result<u32, Infallible> {
        Ok((self.0 >> 32) as u32)
    }
    fn try_next_u64(&mut self) -> Result<u64, Infallible> {
        Ok(self.0)
    }
    fn try_fill_bytes(&mut self, bytes: &mut [u8]) -> Result<(), Infallible> {
        bytes.fill(self.0 as u8);
        Ok(())
    }
}

/// The word of the least nearer tail, on the upper side: θ beside the horizon.
const HORIZON: u64 = 1 << 63;

/// Random unit vectors, a third of them close to ±z where `Frame` divides by 1 + |z|.
fn normals() -> impl Iterator<Item = [f64; 3]> {
    let mut rng = Pcg64::seed_from_u64(5);
    (0..30_000).map(move |i| {
        let spread = if i % 3 == 0 { 1e-6 } else { 1.0 };
        let v = [spread, spread, 1.0].map(|s| s * (rng.next_u64() as f64 / 2f64.powi(63) - 1.0));
        let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        v.map(|c| c / length)
    })
}

fn positive<T: Number, const N: usize>(s: &Sample<T, N>, density: T) {
    assert!(s.at.cos > T::ZERO, "{s:?}");
    assert!(s.density > T::ZERO && s.density.is_finite(), "{s:?}");
    assert_eq!(s.density, density, "{s:?}");
}

/// How many of the rotated vectors do not lie above the surface.
fn in_space<T: Number>(law: impl Spatial<T>) -> usize {
    let ulp = 2f64.powi(1 - T::Raw::DIGITS);
    let mut words = Pcg64::seed_from_u64(2);
    let (mut worst, mut sunk) = (0.0f64, 0);
    for (i, normal) in normals().enumerate() {
        let normal = normal.map(T::of);
        let word = if i % 2 == 0 {
            HORIZON
        } else {
            words.next_u64()
        };
        let drawn = law.sample_with_density(&mut Stuck(word));
        positive(&drawn, law.density(drawn.at));
        assert_eq!(drawn.direction, law.sample(&mut Stuck(word)));
        assert_eq!(drawn.direction[1], drawn.at.cos);
        let s = law.sample_around_with_density(normal, &mut Stuck(word));
        assert_eq!(s.direction, law.sample_around(normal, &mut Stuck(word)));
        assert_eq!((s.at, s.density), (drawn.at, drawn.density));
        let exact = |x: T| <T::Raw as Format>::Wide::of(x.wide());
        let cos = (0..3).fold(Default::default(), |sum: <T::Raw as Format>::Wide, i| {
            sum + exact(normal[i]) * exact(s.direction[i])
        });
        sunk += usize::from(cos.near() <= 0.0);
        worst = worst.max(cos.minus(s.at.cos.wide()).abs() / ulp);
    }
    println!(
        "{}: {worst:.3} ulp of 1, {sunk} not above the surface",
        T::NAME
    );
    assert!(
        worst <= 4.0,
        "{}: cosine to the normal off by {worst}",
        T::NAME
    );
    sunk
}

fn in_plane<T: Number>(law: impl Planar<T>) {
    let mut words = Pcg64::seed_from_u64(3);
    for i in 0..10_000 {
        let word = if i == 0 { HORIZON } else { words.next_u64() };
        let s = law.sample_with_density(&mut Stuck(word));
        positive(&s, law.density(s.at));
        assert_eq!(s.direction, law.sample(&mut Stuck(word)));
        assert_eq!(s.direction, [s.at.sin, s.at.cos]);
    }
}

/// The laws of space with how many of their rotated vectors do not lie above the surface.
#[derive(Default)]
struct Sunk(Vec<(Id, usize)>);

impl<T: Number> LawVisitor<T> for Sunk {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        in_plane::<T>(law);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        self.0.push((id, in_space::<T>(law)));
    }
}

struct Every;

impl NumberVisitor for Every {
    fn number<T: Number>(&mut self) {
        let mut sunk = Sunk::default();
        every_law::<T>(&mut sunk, &[0.0, 20.0]);
        // The bare vector of the flattest lobe does sink: what this test is there for.
        let flat = sunk.0.iter().find(|(id, _)| *id == Id::CosPower(0.0));
        assert!(flat.expect("a lobe").1 > 4000, "{:?}", sunk.0);
    }
}

#[test]
fn samples_in_every_number_type() {
    every_number(&mut Every);
}
