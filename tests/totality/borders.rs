//! Directions on the borders between halves, whose signs of zero say nothing.

use coslobe::CosSin;
use kit::catalogue::{every_law, every_number};
use kit::{EXPONENT, Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw};

struct Borders;

impl<T: Number> LawVisitor<T> for Borders {
    /// Straight down is below the support, as if it had been reached by negative angles.
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

    /// The azimuth of +x is 0 and not 1.
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        for z in [0.0, -0.0] {
            let [_, turn] = law.unwarp_direction([0.6, 0.8, z].map(T::of));
            assert_eq!(turn.wide(), 0.0, "{id} at z = {z:?}");
        }
    }
}

impl NumberVisitor for Borders {
    fn number<T: Number>(&mut self) {
        every_law::<T>(self, &[EXPONENT]);
    }
}

#[test]
fn borders_belong_to_one_side() {
    every_number(&mut Borders);
}
