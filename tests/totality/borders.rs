//! What lies on the border of a domain, or beyond it.

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
    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        let outside = [f64::NAN, f64::INFINITY, -1.0, 2.0].map(T::of);
        let is_nan = |x: T| x.wide().is_nan();
        for beyond in outside {
            for u in [[beyond, T::of(0.25)], [T::of(0.25), beyond]] {
                let d = law.warp_direction(u);
                assert!(d.into_iter().all(is_nan), "{id} at {u:?}: {d:?}");
            }
        }
        let [zero, below] = [0.0, -0.0].map(|x| law.warp_direction([T::of(x); 2]).map(T::wide));
        assert_eq!(zero, below, "{id} at -0");
    }
}

impl NumberVisitor for Borders {
    fn number<T: Number>(&mut self) {
        every_law::<T>(self, &[20.0]);
    }
}

/// Straight down the sign of zero says nothing: below the support, as if it had been reached by
/// negative angles. And what is no probability or no turn gives a direction that is no number.
#[test]
fn borders_of_the_laws() {
    every_number(&mut Borders);
}
