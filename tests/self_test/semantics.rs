//! What the interface promises beside statistics.

use crate::generators::good;
use coslobe::integers::{Fixed16Planar, Fixed16Spatial, FixedPlanar, FixedSpatial};
use coslobe::rand_core::Rng;
use coslobe::self_test::{self, Alarm, Fault, InSpace, Invalid, Place, Subject, Test};
use coslobe::{CosPower, Fixed, Fixed16, Lambert};
use kit::catalogue::{IntegerLaw, IntegerVisitor, every_integer_law, every_law, every_number};
use kit::{EXPONENT, Id, LawVisitor, Number, NumberVisitor, PlanarLaw, SpatialLaw};

fn passes<S: Subject>(mut test: Test<S>) {
    test.run(&mut good(3), self_test::SAMPLES);
    test.verdict(Alarm::OneInMillion).unwrap();
}

struct Laws;

impl<T: Number> LawVisitor<T> for Laws {
    fn planar<L: PlanarLaw<T>>(&mut self, _: Id, law: L) {
        passes(self_test::planar::<T, _>(law));
    }
    fn spatial<L: SpatialLaw<T>>(&mut self, _: Id, law: L) {
        passes(self_test::spatial::<T, _>(law));
    }
}

impl NumberVisitor for Laws {
    fn number<T: Number>(&mut self) {
        every_law::<T>(self, &[EXPONENT]);
    }
}

impl IntegerVisitor for Laws {
    fn law<L: IntegerLaw>(&mut self, _: L) {
        unreachable!("each is planar or spatial");
    }
    fn planar<L: IntegerLaw + FixedPlanar + Fixed16Planar>(&mut self, law: L) {
        passes(self_test::fixed(Fixed(law)));
        passes(self_test::fixed(Fixed16(law)));
    }
    fn spatial<L: IntegerLaw + FixedSpatial + Fixed16Spatial>(&mut self, law: L) {
        passes(self_test::fixed(Fixed(law)));
        passes(self_test::fixed(Fixed16(law)));
    }
    fn power(&mut self, law: coslobe::integers::CosPower) {
        passes(self_test::fixed(Fixed(law)));
    }
}

#[test]
fn a_good_generator_passes_under_every_law_and_type() {
    every_number(&mut Laws);
    every_integer_law(&mut Laws);
}

/// Stuck, biased and short generators; samples that are none.
#[test]
fn integers_are_checked_by_integers() {
    use crate::generators::{biased, period, stuck_bit};
    use fixed::types::I1F31;
    for mut bad in [stuck_bit(1, 4, true), biased(1, !0, 0.05), period(1, 300)] {
        let mut test = self_test::fixed(Fixed(Lambert));
        test.run(&mut bad, self_test::SAMPLES);
        assert!(test.verdict(Alarm::OneInBillion).is_err());
    }
    let invalid = |sample: [f64; 3]| {
        let mut test = self_test::fixed(Fixed(Lambert));
        test.feed(&sample.map(I1F31::saturating_from_num));
        test.verdict(Alarm::OneInBillion)
    };
    for (sample, why) in [
        ([0.6, 0.81, 0.0], Invalid::Length),
        ([-1.0, -1.0, -1.0], Invalid::Length),
        ([-1.0, 0.0, 0.0], Invalid::Support),
        ([0.6, -0.8, 0.0], Invalid::Support),
    ] {
        assert_eq!(
            invalid(sample),
            Err(Fault::Invalid { sample: 1, why }),
            "{sample:?}"
        );
    }
    assert_eq!(invalid([0.0, 1.0, 0.0]), Err(Fault::TooFew { samples: 1 }));
}

#[test]
fn too_few_samples_are_no_verdict() {
    let mut test = self_test::spatial::<f32, _>(Lambert);
    test.run(&mut good(1), self_test::FEWEST - 1);
    let fault = test.verdict(Alarm::OneInMillion).unwrap_err();
    assert_eq!(fault, Fault::TooFew { samples: 4095 });
    assert_eq!(
        fault.to_string(),
        "4095 samples allow no verdict; expected at least 4096"
    );
    test.run(&mut good(2), 1);
    assert!(test.verdict(Alarm::OneInMillion).is_ok());
}

/// Every number of samples finds its limits; after the last possible one nothing is counted.
#[test]
fn any_number_of_samples_can_be_judged() {
    let mut test = self_test::spatial::<f32, _>(Lambert);
    let mut rng = good(1);
    test.run(&mut rng, self_test::FEWEST - 1);
    for n in self_test::FEWEST..=u16::MAX {
        test.run(&mut rng, 1);
        if n % 61 == 0 || n == u16::MAX || (n & (n - 1)) == 0 {
            let report = test.verdict(Alarm::OneInBillion).unwrap();
            assert_eq!((report.samples, report.words), (n, 3 * u32::from(n)));
        }
    }
    test.run(&mut rng, 100);
    assert_eq!(test.verdict(Alarm::OneInBillion).unwrap().samples, u16::MAX);
}

#[test]
fn invalid_samples_are_named_and_the_first_is_kept() {
    let cases: [([f32; 3], Invalid); 7] = [
        ([f32::NAN, 0.8, 0.6], Invalid::NotFinite),
        ([0.0, f32::INFINITY, 0.0], Invalid::NotFinite),
        ([f32::MAX, 0.0, 0.0], Invalid::NotFinite),
        ([0.6, 0.81, 0.0], Invalid::Length),
        ([0.0, 0.0, 0.0], Invalid::Length),
        ([1.0, 0.0, 0.0], Invalid::Support),
        ([0.6, -0.8, 0.0], Invalid::Support),
    ];
    for (sample, why) in cases {
        let mut test = self_test::spatial::<f32, _>(Lambert);
        test.feed(&[0.6, 0.8, 0.0]);
        test.feed(&sample);
        test.feed(&[f32::NAN; 3]);
        let fault = test.verdict(Alarm::OneInMillion).unwrap_err();
        assert_eq!(fault, Fault::Invalid { sample: 2, why }, "{sample:?}");
    }
    // A steep lobe's density underflows long before the horizon.
    let steep = CosPower::new(1e4f32).unwrap();
    let place = InSpace::new(steep).place(&[1.0, 1e-3, 0.0]);
    assert_eq!(place, Err(Invalid::Density));
}

/// As much as the documentation says, in every number type.
#[test]
fn lengths_are_held_to_the_digits_of_the_type() {
    struct Lengths;
    impl NumberVisitor for Lengths {
        fn number<T: Number>(&mut self) {
            let slack = 0.5f64.powi(match T::NAME {
                "f32" | "Precise<f32>" => 18,
                "f64" | "Precise<f64>" => 34,
                _ => 10,
            });
            let subject = InSpace::<T, _>::new(Lambert);
            // Of squares off 1 by a half and by twice of what is allowed.
            let place = |off: f64| subject.place(&[0.0, 1.0 + off, 0.0].map(T::of));
            assert!(place(slack / 4.0).is_ok(), "{}", T::NAME);
            assert_eq!(place(slack), Err(Invalid::Length), "{}", T::NAME);
        }
    }
    every_number(&mut Lengths);
}

#[test]
fn places_are_those_of_the_law() {
    let subject = InSpace::<f32, _>::new(Lambert);
    // sin²θ = 0.36: the lower tail; sector 0 is the one beside +x.
    let place = subject.place(&[0.6, 0.8, 0.0]).unwrap();
    assert_eq!((place.upper, place.sector), (false, Some(0)));
    assert!((f64::from(place.tail) * 0.5f64.powi(31) - 0.36).abs() < 1e-6);
    assert!(subject.place(&[0.0, 0.6, 0.8]).unwrap().upper);
    // 16 azimuths, 16 sectors, each octant's halves side by side.
    let sectors: Vec<u8> = (0..16)
        .map(|i| {
            let phi = f32::to_radians(22.5 * i as f32 + 11.0);
            let at = subject.place(&[0.6 * phi.cos(), 0.8, 0.6 * phi.sin()]);
            at.unwrap().sector.unwrap()
        })
        .collect();
    let mut sorted = sectors.clone();
    sorted.sort_unstable();
    assert_eq!(sorted, (0..16).collect::<Vec<u8>>());
    for octant in sectors.chunks(2) {
        assert_eq!(octant[0] >> 1, octant[1] >> 1, "{sectors:?}");
    }
}

/// A sampler of one's own, under a law of the crate.
#[test]
fn own_subjects_and_a_sampler_that_stops_it_early() {
    struct Own;
    impl Subject for Own {
        type Sample = u32;
        fn draw<R: Rng + ?Sized>(&self, rng: &mut R) -> u32 {
            rng.next_u32()
        }
        fn place(&self, &word: &u32) -> Result<Place, Invalid> {
            let (tail, upper) = (word >> 1, word & 1 == 1);
            let tail = if tail > 1 << 30 {
                (1 << 31) - tail
            } else {
                tail
            };
            Ok(Place {
                tail,
                upper,
                sector: None,
            })
        }
    }
    passes(Test::new(Own));
    let mut test = self_test::spatial::<f32, _>(Lambert);
    test.run(&mut crate::generators::period(1, 3), self_test::SAMPLES);
    let fault = test.verdict(Alarm::OneInBillion).unwrap_err();
    assert_eq!(
        fault,
        Fault::Repeats {
            sample: 5,
            period: 1
        }
    );
    assert_eq!(
        fault.to_string(),
        "the samples up to 5 repeat those 1 before them"
    );
}

#[test]
fn a_fault_is_explained() {
    let mut test = self_test::spatial::<f32, _>(Lambert);
    test.run(
        &mut crate::generators::stuck_bit(1, 9, true),
        self_test::SAMPLES,
    );
    let text = test.verdict(Alarm::OneInBillion).unwrap_err().to_string();
    assert!(
        text.starts_with("too uneven, Bits: χ² = 49")
            && text.ends_with("expected 3.3 to 114.7; most of it in cell 9"),
        "{text}"
    );
}
