//! The optional features: what each adds, and that none changes a value.

#![cfg(any(
    feature = "defmt",
    feature = "heapless",
    feature = "mint",
    feature = "rand",
    feature = "serde"
))]

#[cfg(any(feature = "heapless", feature = "rand"))]
fn generator() -> rand_pcg::Pcg32 {
    rand_pcg::Pcg32::new(0x0C05_10BE, 7)
}

#[cfg(feature = "rand")]
mod rand {
    use super::generator;
    use ::rand::RngExt;
    use ::rand::distr::Distribution;
    use coslobe::{
        Ball, CircleArc, CircleShell, CosPower, Disk, Fast, Lambert, Planar, Precise, Real,
        Spatial, SphereShell,
    };

    /// With `Distribution`, `Planar` and `Spatial` all in scope this has to compile.
    #[test]
    fn sample_is_not_ambiguous() {
        let expected: [f32; 3] = Spatial::sample(&Ball, &mut generator());
        let inherent: [f32; 3] = Ball.sample(&mut generator());
        let through_rng: [f32; 3] = generator().sample(Ball);
        assert_eq!([inherent, through_rng], [expected; 2]);

        let expected: [f64; 2] = Planar::sample(&Disk, &mut generator());
        let inherent: [f64; 2] = Disk.sample(&mut generator());
        let through_rng: [f64; 2] = generator().sample(Disk);
        assert_eq!([inherent, through_rng], [expected; 2]);
    }

    fn planar<T: Real, L: Planar<T> + Distribution<[T; 2]> + Copy>(law: L) {
        let (mut a, mut b) = (generator(), generator());
        for _ in 0..100 {
            assert_eq!(Planar::sample(&law, &mut a), b.sample(law));
        }
        assert_eq!(a, b, "different words drawn");
    }

    fn spatial<T: Real, L: Spatial<T> + Distribution<[T; 3]> + Copy>(law: L) {
        let (mut a, mut b) = (generator(), generator());
        for _ in 0..100 {
            assert_eq!(Spatial::sample(&law, &mut a), b.sample(law));
        }
        assert_eq!(a, b, "different words drawn");
    }

    fn every_law<T: Real>(lobe: CosPower<T>) {
        planar::<T, _>(Disk);
        planar::<T, _>(CircleShell);
        planar::<T, _>(CircleArc);
        spatial::<T, _>(Ball);
        spatial::<T, _>(SphereShell);
        spatial::<T, _>(Lambert);
        spatial(lobe);
    }

    #[test]
    fn a_distribution_has_the_bits_of_its_sampler() {
        every_law(CosPower::new(7.5f32).unwrap());
        every_law(CosPower::new(7.5f64).unwrap());
        every_law(CosPower::new(Precise(7.5f32)).unwrap());
        every_law(CosPower::new(Precise(7.5f64)).unwrap());
        every_law(CosPower::new(Fast(7.5f32)).unwrap());
    }
}

#[cfg(feature = "serde")]
mod serde {
    use ::serde::{Serialize, de::DeserializeOwned};
    use coslobe::{
        Ball, CosPower, CosSin, Disk, Fast, Frame, Lambert, Law, Moments, Precise, Radius,
    };
    use serde_json::{from_str, from_value, to_string, to_value};

    /// Through `Value`, which keeps every bit; serde_json's text may be an ulp off where it is read.
    fn round_trip<T: Serialize + DeserializeOwned + PartialEq + core::fmt::Debug>(value: T) {
        let tree = to_value(&value).unwrap();
        assert_eq!(from_value::<T>(tree).unwrap(), value);
    }

    #[test]
    fn values_come_back() {
        round_trip(Ball);
        round_trip(Disk);
        round_trip(CosSin {
            cos: 0.1f32,
            sin: -0.3,
        });
        round_trip::<Moments<f64>>(Ball.moments());
        for k in [0.0, 0.1, 64.0, 1e300] {
            round_trip(CosPower::new(k).unwrap());
            round_trip(CosPower::new(Precise(k)).unwrap());
        }
        for rho in [f64::MIN_POSITIVE, 0.1, f64::MAX / 4.0] {
            round_trip(Radius::new(rho).unwrap());
        }
    }

    /// The number types are written as the number that they hold.
    #[test]
    fn number_types_are_transparent() {
        round_trip(Precise(0.1f32));
        round_trip(Precise(-0.1f64));
        round_trip(Fast(0.1f32));
        round_trip(CosPower::new(Precise(7.3f32)).unwrap());
        round_trip(CosPower::new(Fast(7.3f32)).unwrap());
        round_trip(Radius::new(Precise(0.1f64)).unwrap());
        round_trip(Radius::new(Fast(0.1f32)).unwrap());
        round_trip::<Moments<Fast<f32>>>(Ball.moments());
        round_trip(Lambert.warp(Fast(0.3f32)));
        assert_eq!(to_string(&Fast(0.5f32)).unwrap(), "0.5");
        assert_eq!(to_string(&Precise(0.5f64)).unwrap(), "0.5");
        assert_eq!(from_str::<Precise<f32>>("0.1").unwrap(), Precise(0.1));
        let text = to_string(&CosPower::new(Precise(64.0f32)).unwrap()).unwrap();
        assert_eq!(text, r#"{"exponent":64.0}"#);
        let law: CosPower<Precise<f32>> = from_str(r#"{"exponent":0.1}"#).unwrap();
        assert_eq!(law.exponent(), Precise(0.1));
    }

    #[test]
    fn frames_come_back_bit_for_bit() {
        let mut rng = rand_pcg::Pcg32::new(1, 1);
        for _ in 0..1000 {
            let normal: [f32; 3] = Lambert.sample(&mut rng);
            round_trip(Frame::from_unit(normal));
            round_trip(Frame::new(normal.map(|c| f64::from(c) - 0.5)).unwrap());
            round_trip(Frame::new(normal.map(|c| Precise(c - 0.5))).unwrap());
            round_trip(Frame::new(normal.map(|c| Fast(c - 0.5))).unwrap());
            let normal: [Fast<f32>; 3] = Lambert.sample(&mut rng);
            round_trip(Frame::from_unit(normal));
        }
        assert_eq!(
            to_string(&Frame::from_unit([0.0, 1.0, 0.0f32])).unwrap(),
            "[0.0,1.0,0.0]"
        );
    }

    fn error<T: DeserializeOwned + core::fmt::Debug>(text: &str) -> String {
        from_str::<T>(text).unwrap_err().to_string()
    }

    /// A number beyond `f32`, which reads as infinite. From a tree: the text may be refused before.
    fn beyond<T: DeserializeOwned + core::fmt::Debug>(text: &str) -> String {
        let tree = from_str(text).unwrap();
        from_value::<T>(tree).unwrap_err().to_string()
    }

    #[test]
    fn invalid_values_are_clear_errors() {
        assert!(
            error::<CosPower<f32>>(r#"{"exponent":-2}"#).starts_with("the exponent is negative")
        );
        assert!(error::<CosPower<f32>>("{}").starts_with("missing field `exponent`"));
        for text in [
            error::<CosPower<Precise<f32>>>(r#"{"exponent":-2}"#),
            error::<CosPower<Precise<f64>>>(r#"{"exponent":-2}"#),
            error::<CosPower<Fast<f32>>>(r#"{"exponent":-2}"#),
        ] {
            assert!(text.starts_with("the exponent is negative"), "{text}");
        }
        let large = r#"{"exponent":1e39}"#;
        for text in [
            beyond::<CosPower<f32>>(large),
            beyond::<CosPower<Precise<f32>>>(large),
            beyond::<CosPower<Fast<f32>>>(large),
        ] {
            assert!(text.starts_with("the exponent is infinite"), "{text}");
        }
        assert!(error::<Frame<Fast<f32>>>("[1,1,0]").starts_with("the normal's length is not 1"));
        assert!(error::<Radius<f64>>("0").starts_with("the radius is below"));
        assert!(error::<Radius<f64>>("1e308").starts_with("the radius is above"));
        assert!(error::<Frame<f64>>("[0,0,0]").starts_with("the normal is zero"));
        assert!(error::<Frame<f64>>("[1,1,0]").starts_with("the normal's length is not 1"));
        assert!(beyond::<Frame<f32>>("[1e39,0,0]").starts_with("the normal has a NaN or infinite"));
        assert!(error::<Frame<f32>>("[1e30,0,0]").starts_with("the normal's length is not 1"));
    }
}

#[cfg(feature = "mint")]
mod mint {
    use ::mint::{ColumnMatrix3, Vector2};
    use coslobe::{CosSin, Frame};

    #[test]
    fn a_pair_is_a_vector_in_the_axes_of_the_paper() {
        let at = CosSin {
            cos: 0.6f32,
            sin: -0.8,
        };
        let v = Vector2::from(at);
        assert_eq!([v.x, v.y], [-0.8, 0.6]);
        assert_eq!(CosSin::from(v), at);
    }

    #[test]
    fn a_frame_is_the_matrix_that_takes_local_to_world() {
        let frame = Frame::new([1.0, -2.0, 3.0f64]).unwrap();
        let m: [[f64; 3]; 3] = ColumnMatrix3::from(frame).into();
        assert_eq!(m, frame.axes());
        let local = [0.25, 0.5, -0.75];
        let product: [f64; 3] =
            core::array::from_fn(|i| local[0] * m[0][i] + local[1] * m[1][i] + local[2] * m[2][i]);
        assert_eq!(product, frame.to_world(local));
    }
}

#[cfg(feature = "heapless")]
mod heapless {
    use super::generator;
    use ::heapless::Vec;
    use coslobe::integration::heapless::{fill_planar, fill_spatial};
    use coslobe::{CircleArc, CosPower, Planar, Spatial};

    #[test]
    fn fills_what_is_free_with_the_samples_in_order() {
        let (mut a, mut b) = (generator(), generator());
        let mut rays = Vec::<[f32; 2], 16>::new();
        rays.push([9.0, 9.0]).unwrap();
        assert_eq!(fill_planar(&CircleArc, &mut a, &mut rays), 15);
        assert_eq!(rays[0], [9.0, 9.0]);
        for &ray in &rays[1..] {
            let alone: [f32; 2] = Planar::sample(&CircleArc, &mut b);
            assert_eq!(ray, alone);
        }
        assert_eq!(a, b, "a word was drawn for nothing");
        assert_eq!(fill_planar(&CircleArc, &mut a, &mut rays), 0);
        assert_eq!(a, b, "a full vector drew a word");
    }

    #[test]
    fn fills_space_and_nothing() {
        let (mut a, mut b) = (generator(), generator());
        let lobe = CosPower::new(2.5f64).unwrap();
        let mut rays = Vec::<[f64; 3], 5>::new();
        assert_eq!(fill_spatial(&lobe, &mut a, &mut rays), 5);
        for &ray in &rays {
            let alone: [f64; 3] = Spatial::sample(&lobe, &mut b);
            assert_eq!(ray, alone);
        }
        assert_eq!(
            fill_spatial(&lobe, &mut a, &mut Vec::<[f64; 3], 0>::new()),
            0
        );
        assert_eq!(a, b);
    }
}

#[cfg(feature = "defmt")]
mod defmt {
    use coslobe::{
        Ball, CircleArc, CircleShell, CosPower, CosSin, Disk, ExponentError, Fast, Frame, Lambert,
        Measure, Moments, NormalError, Precise, Radius, RadiusError, SphereShell, Tails, self_test,
    };

    /// Only its type is checked: running `Format` needs a logger, which a host has not.
    fn is_format<T: ::defmt::Format>() {}

    #[test]
    fn public_types_can_be_logged() {
        is_format::<(Disk, CircleShell, CircleArc)>();
        is_format::<(Ball, SphereShell, Lambert)>();
        is_format::<(CosPower<f32>, CosPower<f64>)>();
        is_format::<(CosSin<f32>, Tails<f64>, Moments<f32>)>();
        is_format::<(Radius<f32>, Frame<f32>, Measure)>();
        is_format::<(Precise<f32>, CosPower<Precise<f64>>)>();
        is_format::<(Fast<f32>, CosPower<Fast<f32>>, CosSin<Fast<f32>>)>();
        is_format::<(Precise<f64>, Tails<Precise<f32>>, Radius<Fast<f32>>)>();
        is_format::<(ExponentError, RadiusError, NormalError)>();
        #[cfg(feature = "fixed")]
        is_format::<(coslobe::Fixed<Ball>, coslobe::Fixed16<Disk>)>();
        is_format::<(
            self_test::Report,
            self_test::Fault,
            self_test::Alarm,
            self_test::Place,
        )>();
    }
}

/// The laws in integers by the same features, with the bits of their own `sample`.
#[cfg(feature = "fixed")]
mod fixed {
    #[cfg(any(feature = "heapless", feature = "rand"))]
    use super::generator;
    use ::fixed::types::{I1F15, I1F31, U16F16};
    use coslobe::integers::{CosPower, FixedFrame};
    use coslobe::{Ball, Fixed, Fixed16, Lambert};

    #[cfg(feature = "rand")]
    #[test]
    fn distributions_draw_samples() {
        use ::rand::RngExt;
        let (mut a, mut b) = (generator(), generator());
        for _ in 0..100 {
            assert_eq!(a.sample(Fixed(Ball)), Fixed(Ball).sample(&mut b));
            assert_eq!(a.sample(Fixed16(Ball)), Fixed16(Ball).sample(&mut b));
        }
        assert_eq!(a, b, "different words drawn");
    }

    #[cfg(feature = "heapless")]
    #[test]
    fn vectors_are_filled_with_samples() {
        use coslobe::integration::heapless::fill_fixed;
        let (mut a, mut b) = (generator(), generator());
        let mut rays = heapless::Vec::<[I1F15; 3], 8>::new();
        let first = Fixed16(Lambert).sample(&mut b);
        assert!(rays.push(first).is_ok());
        let _ = Fixed16(Lambert).sample(&mut a);
        assert_eq!(fill_fixed(&Fixed16(Lambert), &mut a, &mut rays), 7);
        assert_eq!(rays[0], first);
        for ray in &rays[1..] {
            assert_eq!(*ray, Fixed16(Lambert).sample(&mut b));
        }
        assert_eq!(fill_fixed(&Fixed16(Lambert), &mut a, &mut rays), 0);
        assert_eq!(a, b, "different words drawn");
    }

    #[cfg(feature = "serde")]
    #[test]
    fn laws_and_frames_come_back() {
        let law = Fixed(CosPower::new(U16F16::from_num(64.5)));
        let text = serde_json::to_string(&law).expect("it is written");
        assert!(text.contains("exponent"), "{text}");
        let back: Fixed<CosPower> = serde_json::from_str(&text).expect("it is read");
        assert_eq!(back, law);
        let text = serde_json::to_string(&Fixed16(Ball)).expect("it is written");
        assert_eq!(
            serde_json::from_str::<Fixed16<Ball>>(&text).expect("it is read"),
            Fixed16(Ball)
        );
        let frame = FixedFrame::from_unit([0.6, 0.0, -0.8].map(I1F31::from_num));
        let text = serde_json::to_string(&frame).expect("it is written");
        let back: FixedFrame<I1F31> = serde_json::from_str(&text).expect("it is read");
        assert_eq!(back, frame);
        let zero = serde_json::to_string(&[I1F31::ZERO; 3]).expect("it is written");
        assert!(serde_json::from_str::<FixedFrame<I1F31>>(&zero).is_err());
    }

    /// A direction, a frame and a sample can be logged.
    #[cfg(feature = "defmt")]
    #[test]
    fn everything_is_a_format() {
        fn logs<T: defmt::Format>() {}
        logs::<[I1F31; 3]>();
        logs::<Fixed<CosPower>>();
        logs::<Fixed16<Ball>>();
        logs::<FixedFrame<I1F15>>();
        logs::<coslobe::Sample<I1F31, 3, U16F16>>();
    }
}
