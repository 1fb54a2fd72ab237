//! Generators that fail, as hardware does: the error is handed on, no word is drawn after it, and
//! without one the words and bits are those of `sample`.

use coslobe::integers::CosPower;
use coslobe::rand_core::{Rng, TryRng};
use coslobe::{Fixed, Fixed16, try_from_fn};
use kit::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law, every_law, every_number};
use kit::{Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw};
use rand_pcg::Pcg32;
use std::fmt::{self, Debug};

#[derive(Clone, Copy, Debug, PartialEq)]
struct Broken(u32);

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "broken at word {}", self.0)
    }
}

impl std::error::Error for Broken {}

/// The words of [`Pcg32`] until the one that breaks.
fn breaking(
    at: u32,
) -> (
    impl TryRng<Error = Broken>,
    std::rc::Rc<std::cell::Cell<u32>>,
) {
    let drawn = std::rc::Rc::new(std::cell::Cell::new(0));
    let (count, mut words) = (drawn.clone(), Pcg32::new(7, 9));
    let rng = try_from_fn(move || {
        let i = count.get();
        count.set(i + 1);
        if i == at {
            Err(Broken(i))
        } else {
            Ok(words.next_u32())
        }
    });
    (rng, drawn)
}

/// `of` is `try_sample`; `sample` what it has to give.
fn holds<D: Debug>(
    name: &str,
    sample: impl Fn(&mut Pcg32) -> D,
    of: impl Fn(&mut dyn TryRng<Error = Broken>) -> Result<D, Broken>,
) {
    let (mut whole, drawn) = breaking(u32::MAX);
    let expected = sample(&mut Pcg32::new(7, 9));
    let found = of(&mut whole).expect("nothing breaks");
    assert_eq!(format!("{found:?}"), format!("{expected:?}"), "{name}");
    let words = drawn.get();
    assert!(words > 0, "{name}");
    for at in 0..words {
        let (mut rng, drawn) = breaking(at);
        let error = of(&mut rng).expect_err("it breaks");
        assert_eq!((error, drawn.get()), (Broken(at), at + 1), "{name}");
    }
}

struct Each;

impl<T: Number> LawVisitor<T> for Each {
    fn planar<L: PlanarLaw<T>>(&mut self, id: Id, law: L) {
        let name = format!("{id} {}", T::NAME);
        holds(&name, |rng| law.sample(rng), |rng| law.try_sample(rng));
    }

    fn spatial<L: SpatialLaw<T>>(&mut self, id: Id, law: L) {
        let name = format!("{id} {}", T::NAME);
        holds(&name, |rng| law.sample(rng), |rng| law.try_sample(rng));
    }
}

impl NumberVisitor for Each {
    fn number<T: Number>(&mut self) {
        every_law::<T>(self, &[20.0]);
    }
}

#[test]
fn floats_hand_errors_on() {
    every_number(&mut Each);
}

struct Integers;

impl IntegerVisitor for Integers {
    fn law<L: IntegerLaw>(&mut self, law: L) {
        let (long, short) = (Fixed(law), Fixed16(law));
        let name = format!("Fixed({})", L::ID);
        holds(&name, |rng| long.sample(rng), |rng| long.try_sample(rng));
        let name = format!("Fixed16({})", L::ID);
        holds(&name, |rng| short.sample(rng), |rng| short.try_sample(rng));
    }

    fn power(&mut self, law: CosPower) {
        let law = Fixed(law);
        holds(
            "Fixed(CosPower)",
            |rng| law.sample(rng),
            |rng| law.try_sample(rng),
        );
    }
}

#[test]
fn integers_hand_errors_on() {
    every_integer_law(&mut Integers);
}
