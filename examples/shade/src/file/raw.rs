//! A scene as it is written. Every key that is not named here is an error.

use serde::Deserialize;
use shade_core::LawName;
use std::collections::BTreeMap;
use toml::Spanned;

pub(super) type Value = Spanned<f64>;
pub(super) type Values = Spanned<Vec<f64>>;

/// A scene file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Raw {
    /// What is to be seen.
    pub title: String,
    /// Two dimensions instead of three.
    #[serde(default)]
    pub flatland: bool,
    /// Most scatterings of a path.
    pub bounces: Option<Spanned<i64>>,
    /// The law that directions of diffuse reflection are drawn by.
    pub law: Option<Spanned<LawName>>,
    /// Its exponent, for `cos_power`.
    pub exponent: Option<Value>,
    /// How a lamp's two strategies are combined.
    #[serde(default)]
    pub combine: CombineName,
    pub image: Image,
    pub camera: Spanned<Camera>,
    pub sky: Option<Spanned<Sky>>,
    pub sun: Option<Sun>,
    pub fog: Option<Fog>,
    #[serde(default)]
    pub material: BTreeMap<Spanned<String>, Spanned<Material>>,
    #[serde(default)]
    pub lamp: Vec<Spanned<Lamp>>,
    #[serde(default)]
    pub sphere: Vec<Spanned<Sphere>>,
    #[serde(default)]
    pub plate: Vec<Spanned<Plate>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Image {
    pub width: Spanned<i64>,
    pub height: Spanned<i64>,
    pub samples: Spanned<i64>,
    pub seed: Option<Spanned<i64>>,
    /// What the radiance is multiplied by before it is encoded as sRGB.
    pub exposure: Option<Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Space: where it is.
    pub eye: Option<Values>,
    /// Space: what is in the image's middle.
    pub look_at: Option<Values>,
    /// Space: field of view from bottom to top, in degrees.
    pub fov: Option<Value>,
    /// Flatland: the view's middle.
    pub centre: Option<Values>,
    /// Flatland: the view's height.
    pub height: Option<Value>,
    /// Width of the pixel filter, in pixels.
    pub filter: Option<Value>,
    /// Space: a lens, instead of a pinhole.
    pub lens: Option<Spanned<Lens>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lens {
    pub radius: Value,
    /// Distance of the plane in focus.
    pub focus: Value,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sky {
    /// From everywhere; or else both of the following.
    pub constant: Option<Values>,
    pub nadir: Option<Values>,
    pub zenith: Option<Values>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sun {
    /// Direction to the sun, of any length.
    pub towards: Values,
    pub irradiance: Values,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Fog {
    pub centre: Values,
    pub radius: Value,
    pub absorption: Option<Values>,
    pub scattering: Option<Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    pub diffuse: Option<Values>,
    pub gloss: Option<Spanned<Gloss>>,
    pub emission: Option<Values>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Gloss {
    pub reflectance: Values,
    pub law: Spanned<LawName>,
    /// For `cos_power`.
    pub exponent: Option<Value>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lamp {
    pub centre: Values,
    pub radius: Value,
    pub radiance: Values,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    pub centre: Values,
    pub radius: Value,
    pub material: Spanned<String>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plate {
    pub centre: Values,
    /// Space: two sides, at a right angle; flatland: one.
    pub sides: Spanned<Vec<Values>>,
    pub material: Spanned<String>,
}

/// See `shade_core::effect::Combine`.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub enum CombineName {
    #[default]
    Balance,
    Power,
    Light,
    Scatter,
}
