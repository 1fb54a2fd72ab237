//! The laws in integers by the same features, with the bits of their own `sample`.

#[cfg(any(feature = "heapless", feature = "rand"))]
use crate::generator;
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
