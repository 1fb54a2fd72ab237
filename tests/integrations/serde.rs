//! Values come back, and constructors' checks hold on the way in.

use ::serde::{Serialize, de::DeserializeOwned};
use coslobe::{Ball, CosPower, CosSin, Disk, Fast, Frame, Lambert, Law, Moments, Precise, Radius};
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
    assert!(error::<CosPower<f32>>(r#"{"exponent":-2}"#).starts_with("the exponent is negative"));
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
