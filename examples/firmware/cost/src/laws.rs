//! The library's operations: law × operation in one number type.

use crate::Meter;
use crate::inputs::{angles, pairs, probabilities, square};
use coslobe::{CosSin, Law, Planar, Spatial};
use kit::{Id, LawVisitor, Number, PlanarLaw, SpatialLaw, catalogue};
use rand_pcg::Pcg32;
use rand_xorshift::XorShiftRng;

/// Exponent of the power law that is counted: that of `tools/accuracy_cost`.
pub(crate) const EXPONENT: f64 = 20.0;

/// Every operation of every law.
pub fn every_law<T: Number>(meter: &mut Meter) {
    catalogue::every_law::<T>(&mut Counted(meter), &[EXPONENT]);
}

struct Counted<'a, 'm>(&'a mut Meter<'m>);

impl<T: Number> LawVisitor<T> for Counted<'_, '_> {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        planar::<T, L>(self.0, L::ID.name(), &law);
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        spatial::<T, L>(self.0, counted_name(id), &law);
    }
}

/// A law's name in the table.
pub(crate) fn counted_name(id: Id) -> &'static str {
    match id {
        Id::CosPower(_) => "CosPower(20)",
        id => id.name(),
    }
}

// The methods themselves, not closures around them: a method that two operations share is not
// inlined, and a closure would add its own call to the count.

fn law<T: Number, L: Law<T>>(meter: &mut Meter, law: &L, planar: bool) {
    let (theta, at, p) = (
        angles::<T>(planar),
        pairs::<T>(planar),
        probabilities::<T>(),
    );
    meter.call("pdf", law, &theta, L::pdf, |_, x| x);
    meter.call("ln_pdf", law, &theta, L::ln_pdf, |_, x| x);
    meter.call("cdf", law, &theta, L::cdf, |_, x| x);
    meter.call("sf", law, &theta, L::sf, |_, x| x);
    meter.call("density", law, &at, L::density, first);
    meter.call("lambert_weight", law, &at, L::lambert_weight, first);
    meter.call("unwarp", law, &at, L::unwarp, first);
    meter.call("unwarp_sf", law, &at, L::unwarp_sf, first);
    meter.call("warp", law, &p, L::warp, both);
    meter.call("warp_sf", law, &p, L::warp_sf, both);
    meter.call("quantile", law, &p, L::quantile, |_, x| x);
    meter.call("isf", law, &p, L::isf, |_, x| x);
}

fn first<L, T>(_: &L, at: CosSin<T>) -> T {
    at.cos
}

fn both<L, T: Copy>(_: &L, x: T) -> CosSin<T> {
    CosSin { cos: x, sin: x }
}

fn planar<T: Number, L: Planar<T>>(meter: &mut Meter, name: &'static str, l: &L) {
    meter.law(name);
    law(meter, l, true);
    meter.draw::<Pcg32, _, _>(l, L::sample, |_, _| [T::of(0.0); 2]);
    meter.draw::<XorShiftRng, _, _>(l, L::sample, |_, _| [T::of(0.0); 2]);
}

fn spatial<T: Number, L: Spatial<T>>(meter: &mut Meter, name: &'static str, l: &L) {
    meter.law(name);
    law(meter, l, false);
    let theta = angles::<T>(false);
    meter.call("pdf_solid_angle", l, &theta, L::pdf_solid_angle, |_, x| x);
    let (u, nothing) = (square::<T>(), |_: &L, [u, v]: [T; 2]| [u, v, u]);
    meter.call("warp_direction", l, &u, L::warp_direction, nothing);
    meter.draw::<Pcg32, _, _>(l, L::sample, |_, _| [T::of(0.0); 3]);
    meter.draw::<XorShiftRng, _, _>(l, L::sample, |_, _| [T::of(0.0); 3]);
    let normal = [0.48, 0.6, 0.64].map(T::of);
    meter.draw_as::<Pcg32, _, _>(
        "sample_around",
        &(l, normal),
        |&(l, normal), rng| l.sample_around(normal, rng),
        |_, _| [T::of(0.0); 3],
    );
}
