//! Straight down, where the sign of zero says nothing, is below the support: as if it had been
//! reached by negative angles.

use coslobe::CosSin;
use kit::catalogue::{every_law, every_number};
use kit::{Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw};

struct Borders;

impl<T: Number> LawVisitor<T> for Borders {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        for sin in [0.0, -0.0].map(T::of) {
            let at = CosSin {
                cos: T::of(-1.0),
                sin,
            };
            let tails = [law.unwarp(at), law.unwarp_sf(at)].map(T::wide);
            assert_eq!(tails, [0.0, 1.0], "{id} at {at:?}");
        }
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, _: L) {}
}

impl NumberVisitor for Borders {
    fn number<T: Number>(&mut self) {
        every_law::<T>(self, &[]);
    }
}

#[test]
fn straight_down_is_below_every_law_of_the_plane() {
    every_number(&mut Borders);
}
