//! A scene as it is written. Every key that is not named here is an error.

use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

pub(crate) type Value = Spanned<f64>;
pub(crate) type Values = Spanned<Vec<f64>>;

/// A scene file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Raw {
    /// What is to be seen.
    pub(crate) title: String,
    /// Two dimensions instead of three.
    #[serde(default)]
    pub(crate) flatland: bool,
    /// Most scatterings of a path.
    pub(crate) bounces: Option<Spanned<i64>>,
    /// The law that directions of diffuse reflection are drawn by.
    pub(crate) law: Option<Spanned<LawName>>,
    /// Its exponent, for `cos_power`.
    pub(crate) exponent: Option<Value>,
    /// How a lamp's two strategies are combined.
    #[serde(default)]
    pub(crate) combine: CombineName,
    pub(crate) image: Image,
    pub(crate) camera: Spanned<Camera>,
    pub(crate) sky: Option<Spanned<Sky>>,
    pub(crate) sun: Option<Sun>,
    pub(crate) fog: Option<Fog>,
    #[serde(default)]
    pub(crate) material: BTreeMap<Spanned<String>, Spanned<Material>>,
    #[serde(default)]
    pub(crate) lamp: Vec<Spanned<Lamp>>,
    #[serde(default)]
    pub(crate) sphere: Vec<Spanned<Sphere>>,
    #[serde(default)]
    pub(crate) plate: Vec<Spanned<Plate>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Image {
    pub(crate) width: Spanned<i64>,
    pub(crate) height: Spanned<i64>,
    pub(crate) samples: Spanned<i64>,
    pub(crate) seed: Option<Spanned<i64>>,
    /// What the radiance is multiplied by before it is encoded as sRGB.
    pub(crate) exposure: Option<Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Camera {
    /// Space: where it is.
    pub(crate) eye: Option<Values>,
    /// Space: what is in the image's middle.
    pub(crate) look_at: Option<Values>,
    /// Space: field of view from bottom to top, in degrees.
    pub(crate) fov: Option<Value>,
    /// Flatland: the view's middle.
    pub(crate) centre: Option<Values>,
    /// Flatland: the view's height.
    pub(crate) height: Option<Value>,
    /// Width of the pixel filter, in pixels.
    pub(crate) filter: Option<Value>,
    /// Space: a lens, instead of a pinhole.
    pub(crate) lens: Option<Spanned<Lens>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Lens {
    pub(crate) radius: Value,
    /// Distance of the plane in focus.
    pub(crate) focus: Value,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sky {
    /// From everywhere; or else both of the following.
    pub(crate) constant: Option<Values>,
    pub(crate) nadir: Option<Values>,
    pub(crate) zenith: Option<Values>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sun {
    /// Direction to the sun, of any length.
    pub(crate) towards: Values,
    pub(crate) irradiance: Values,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Fog {
    pub(crate) centre: Values,
    pub(crate) radius: Value,
    pub(crate) absorption: Option<Values>,
    pub(crate) scattering: Option<Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Material {
    pub(crate) diffuse: Option<Values>,
    pub(crate) gloss: Option<Spanned<Gloss>>,
    pub(crate) emission: Option<Values>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Gloss {
    pub(crate) reflectance: Values,
    pub(crate) law: Spanned<LawName>,
    /// For `cos_power`.
    pub(crate) exponent: Option<Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Lamp {
    pub(crate) centre: Values,
    pub(crate) radius: Value,
    pub(crate) radiance: Values,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sphere {
    pub(crate) centre: Values,
    pub(crate) radius: Value,
    pub(crate) material: Spanned<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Plate {
    pub(crate) centre: Values,
    /// Space: two sides, at a right angle; flatland: one.
    pub(crate) sides: Spanned<Vec<Values>>,
    pub(crate) material: Spanned<String>,
}

/// The crate's laws.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(crate) enum LawName {
    Lambert,
    SphereShell,
    Ball,
    CosPower,
    CircleArc,
    CircleShell,
    Disk,
}

impl std::str::FromStr for LawName {
    type Err = String;
    fn from_str(name: &str) -> Result<Self, String> {
        use serde::de::value::{Error, StrDeserializer};
        LawName::deserialize(StrDeserializer::<Error>::new(name)).map_err(|e| e.to_string())
    }
}

impl LawName {
    pub(crate) fn is_flat(self) -> bool {
        matches!(self, Self::CircleArc | Self::CircleShell | Self::Disk)
    }
}

/// See `shade_core::effect::Combine`.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(crate) enum CombineName {
    #[default]
    Balance,
    Power,
    Light,
    Scatter,
}
