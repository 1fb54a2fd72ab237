//! Images of the shader with a scene's effects: the code of absent effects is absent.

use super::image::build;
use super::sources::bytes_by_function;
use super::{ensure, whole};
use crate::boards::Board;
use crate::failure::Result;
use shade_core::Effect::{
    Absorption, Diffuse, Filter, Gloss, Lamp, Lens, Mix, Scattering, Sky, Sun,
};
use shade_core::{Effect, Set};
use std::collections::BTreeMap;

/// Where the code of effects is in the shader's core, and the effects any of which has it. Of the
/// others the camera is never absent, emitters are one term of a sum, and several bounces are a
/// loop.
const CODE: [(&str, &[Effect]); 10] = [
    ("effect/filter.rs::", &[Filter]),
    ("effect/lens.rs::", &[Lens]),
    ("effect/sky.rs::", &[Sky]),
    ("effect/sun.rs::", &[Sun]),
    ("effect/lamp.rs::", &[Lamp]),
    ("effect/diffuse.rs::", &[Diffuse]),
    ("effect/gloss.rs::", &[Gloss]),
    ("material.rs::chooses_gloss", &[Mix]),
    // Scattering alone takes light away as well.
    ("effect/absorption.rs::", &[Absorption, Scattering]),
    ("effect/scattering.rs::scattered_at", &[Scattering]),
];

/// Bytes of flash of an image of nothing.
pub(crate) fn nothing(board: &Board) -> Result<u64> {
    let (_, image) = build(board, "x ^ rng.0", None)?;
    Ok(image.flash())
}

/// Bytes of flash of an image that shades pixels of the scene of type `scene`.
///
/// # Errors
/// If it holds a panic, an allocation, static RAM, soft doubles, or code of an effect not in
/// `claimed`; or none of one that is.
pub(crate) fn shader(board: &Board, scene: &str, claimed: Set) -> Result<u64> {
    let (path, image) = build(board, &format!("shaded::<{scene}>(x, rng)"), None)?;
    whole::complete(&image)?;
    whole::no_ram(&image)?;
    whole::no_double(&image)?;
    let functions = bytes_by_function(&path, &image, "examples/shade/core/src")?;
    agree(claimed, &functions)?;
    Ok(image.flash())
}

/// Whether code is there of just the effects claimed.
fn agree(claimed: Set, functions: &BTreeMap<String, u64>) -> Result<()> {
    for (code, effects) in CODE {
        let bytes: Vec<_> = functions
            .iter()
            .filter(|(name, _)| name.starts_with(code))
            .map(|(name, bytes)| format!("{bytes} bytes from {name}"))
            .collect();
        let name = effects[0].name();
        if effects.iter().any(|&e| claimed.has(e)) {
            ensure(!bytes.is_empty(), || {
                format!("no code of {name} ({code}), which the scene calls for")
            })?;
        } else {
            ensure(bytes.is_empty(), || {
                format!("code of {name}, which is absent: {}", bytes.join(", "))
            })?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_effect_more_or_less_is_named() {
        let functions = |names: &[&str]| names.iter().map(|n| ((*n).to_owned(), 2)).collect();
        let claimed = Set::LEAST.with(Sky).with(Scattering);
        let just = [
            "effect/sky.rs::radiance",
            "effect/absorption.rs::faded",
            "effect/scattering.rs::scattered_at",
            "path.rs::segment",
        ];
        assert!(agree(claimed, &functions(&just)).is_ok());
        let more = [&just[..], &["effect/lamp.rs::met"]].concat();
        let error = agree(claimed, &functions(&more)).unwrap_err().to_string();
        assert!(
            error.contains("2 bytes from effect/lamp.rs::met"),
            "{error}"
        );
        let error = agree(claimed, &functions(&just[1..]))
            .unwrap_err()
            .to_string();
        assert!(error.contains("no code of environment light"), "{error}");
    }
}
