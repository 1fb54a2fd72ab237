//! `serde`: the types whose values are checked or rebuilt when read; the plain ones derive.

#[cfg(feature = "fixed")]
use crate::integers::{Component, FixedFrame};
use crate::{CosPower, Frame, NormalError, Radius, Real};
use core::fmt;
use serde::de::{Deserialize, Deserializer, Error};
use serde::ser::{Serialize, Serializer};

/// The fields as the derived `Serialize` of [`CosPower`] writes them.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "CosPower", deny_unknown_fields)]
struct Lobe<T> {
    exponent: T,
}

/// From `{ "exponent": k }`; an exponent that [`CosPower::new`] refuses is an error.
///
/// ```
/// use coslobe::CosPower;
/// let law: CosPower<f32> = serde_json::from_str(r#"{ "exponent": 64 }"#)?;
/// assert_eq!(law.exponent(), 64.0);
/// assert!(serde_json::from_str::<CosPower<f32>>(r#"{ "exponent": -1 }"#).is_err());
/// # Ok::<(), serde_json::Error>(())
/// ```
impl<'de, T: Real + Deserialize<'de>> Deserialize<'de> for CosPower<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let lobe = Lobe::deserialize(deserializer)?;
        CosPower::new(lobe.exponent).map_err(Error::custom)
    }
}

/// As the float law: `{ "exponent": k }`, k as the `fixed` crate writes it.
#[cfg(feature = "fixed")]
impl Serialize for crate::integers::CosPower {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let exponent = self.exponent();
        Lobe { exponent }.serialize(serializer)
    }
}

/// From `{ "exponent": k }`: every `k` is one.
#[cfg(feature = "fixed")]
impl<'de> Deserialize<'de> for crate::integers::CosPower {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Self::new(Lobe::deserialize(deserializer)?.exponent))
    }
}

/// As its normal alone.
#[cfg(feature = "fixed")]
impl<C: Component> Serialize for FixedFrame<C> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.normal().serialize(serializer)
    }
}

/// From a normal; one that [`FixedFrame::new`] refuses is an error.
#[cfg(feature = "fixed")]
impl<'de, C: Component> Deserialize<'de> for FixedFrame<C> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        FixedFrame::new(<[C; 3]>::deserialize(deserializer)?).map_err(Error::custom)
    }
}

/// From the bare number; one that [`Radius::new`] refuses is an error.
///
/// ```
/// use coslobe::Radius;
/// let rho: Radius<f64> = serde_json::from_str("0.25")?;
/// assert_eq!(rho.get(), 0.25);
/// assert!(serde_json::from_str::<Radius<f64>>("0.0").is_err());
/// # Ok::<(), serde_json::Error>(())
/// ```
impl<'de, T: Real + Deserialize<'de>> Deserialize<'de> for Radius<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Radius::new(T::deserialize(deserializer)?).map_err(Error::custom)
    }
}

/// As its normal alone, from which the same axes are rebuilt bit for bit where the format keeps the
/// numbers' bits (serde_json's text: with its feature `float_roundtrip`).
impl<T: Real + Serialize> Serialize for Frame<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let [_, normal, _] = self.axes();
        normal.serialize(serializer)
    }
}

/// From a unit normal, by [`Frame::from_unit`]; one whose length is not 1 to half the format's
/// digits is an error.
///
/// ```
/// use coslobe::Frame;
/// let frame: Frame<f32> = serde_json::from_str("[0.6, 0.0, -0.8]")?;
/// assert_eq!(frame, Frame::from_unit([0.6, 0.0, -0.8]));
/// assert!(serde_json::from_str::<Frame<f32>>("[0.0, 0.0, 2.0]").is_err());
/// # Ok::<(), serde_json::Error>(())
/// ```
impl<'de, T: Real + Deserialize<'de>> Deserialize<'de> for Frame<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let normal = <[T; 3]>::deserialize(deserializer)?;
        check_unit(normal).map_err(Error::custom)?;
        Ok(Frame::from_unit(normal))
    }
}

/// Why a normal read from data was refused.
enum UnitError {
    Normal(NormalError),
    Length,
}

impl fmt::Display for UnitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            UnitError::Normal(error) => error.fmt(f),
            UnitError::Length => {
                f.write_str("the normal's length is not 1; expected a unit vector")
            }
        }
    }
}

fn check_unit<T: Real>(normal: [T; 3]) -> Result<(), UnitError> {
    Frame::new(normal).map_err(UnitError::Normal)?;
    let excess = normal.iter().fold(-T::ONE, |sum, &c| sum + c * c);
    if excess.abs() <= T::from_base(T::UNIT_SLACK) {
        Ok(())
    } else {
        Err(UnitError::Length)
    }
}
