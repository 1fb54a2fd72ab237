//! Images of every operation: no panic, no allocation, no static RAM, no soft double; no float at
//! all in fixed point.

use super::elf::Image;
use super::image::build;
use super::{Shown, caught, ensure, symbols, thumb};
use crate::boards::Board;
use crate::failure::Result;
use indicatif::ProgressBar;

/// Images that [`show`] builds.
pub(super) const IMAGES: u64 = 10;

/// Every operation in the types that compute in `f32` alone.
const SINGLE: &str = "everything::<f32>(x, rng) ^ everything::<Fast<f32>>(x, rng)";
/// Every operation in the types that compute in `f64`.
const DOUBLE: &str = "everything::<f64>(x, rng) ^ everything::<Precise<f32>>(x, rng) \
                      ^ everything::<Precise<f64>>(x, rng)";
/// Every operation in fixed point, and checks of it.
const FIXED: &str = "fixed_everything(x, rng)";
/// The same in 16 bits.
const FIXED16: &str = "fixed16_everything(x, rng)";
/// All of them, and the types that they are in.
pub(super) const CALLS: [(&str, &str); 4] = [
    ("f32 and Fast<f32>", SINGLE),
    ("f64 and Precise", DOUBLE),
    ("Fixed", FIXED),
    ("Fixed16", FIXED16),
];
/// What is planted, beside little else.
pub(super) const LITTLE: &str = "spatial_sampler::<f32>(Lambert, rng)";
const LITTLE_FIXED: &str = "fixed_sampler(Lambert, rng)";
/// A product that Cortex-M0 has no instruction for.
const LONG: &str = "fixed16_sampler(Lambert, rng) ^ long_product(x, rng)";

pub(super) fn show(board: &Board, bar: &ProgressBar) -> Shown {
    let built = |calls: &str, planted: Option<&str>| {
        let image = build(board, calls, planted).map(|(_, image)| image);
        bar.inc(1);
        image
    };
    let float = if board.name == "M4F" {
        "FPU instructions"
    } else {
        "soft float"
    };
    let planted = |feature: &str, check: fn(&Image) -> Result<()>, reason: &str| {
        let beside = if feature == "plant-float" {
            LITTLE_FIXED
        } else {
            LITTLE
        };
        let outcome = built(beside, Some(feature)).and_then(|image| check(&image));
        (format!("{feature} is caught"), caught(outcome, reason))
    };
    vec![
        (
            "f32 and Fast<f32>: no panic, allocation, static RAM or soft double".to_owned(),
            built(SINGLE, None).and_then(|image| {
                complete(&image)?;
                no_ram(&image)?;
                no_double(&image)
            }),
        ),
        (
            "f64 and Precise: no panic, allocation or static RAM; soft double is seen".to_owned(),
            built(DOUBLE, None).and_then(|image| {
                complete(&image)?;
                no_ram(&image)?;
                caught(no_double(&image), "soft double")
            }),
        ),
        (
            "Fixed: no panic, allocation or static RAM, and no float at all".to_owned(),
            built(FIXED, None).and_then(|image| {
                complete(&image)?;
                no_ram(&image)?;
                no_float(&image)
            }),
        ),
        (
            "Fixed16: no panic, allocation or static RAM, no float, and no routine for 64 bits"
                .to_owned(),
            built(FIXED16, None).and_then(|image| {
                complete(&image)?;
                no_ram(&image)?;
                no_float(&image)?;
                no_long(&image)
            }),
        ),
        (
            "a product of 64 bits is caught where it is a routine".to_owned(),
            built(LONG, None).and_then(|image| match board.name {
                "M0" => caught(no_long(&image), "64 bits"),
                _ => no_long(&image),
            }),
        ),
        planted(
            "plant-panic",
            complete,
            "undefined symbol: a_panic_is_reachable",
        ),
        planted(
            "plant-allocation",
            complete,
            "undefined symbol: an_allocation_is_reachable",
        ),
        planted("plant-ram", no_ram, "static RAM"),
        planted("plant-double", no_double, "soft double"),
        planted("plant-float", no_float, float),
    ]
}

/// It has its entry, so the linker has not dropped what the proof is about.
pub(super) fn complete(image: &Image) -> Result<()> {
    let entry = image.symbols().iter().any(|s| s == "_start");
    ensure(entry && !image.code().is_empty(), || {
        "no entry _start, or no code".to_owned()
    })
}

pub(super) fn no_ram(image: &Image) -> Result<()> {
    let bytes = image.static_ram();
    ensure(bytes == 0, || format!("{bytes} bytes of static RAM"))
}

pub(super) fn no_double(image: &Image) -> Result<()> {
    none(image, "soft double", symbols::is_double)
}

/// No product, quotient or shift of 64 bits, nor a quotient of 32, by a routine.
fn no_long(image: &Image) -> Result<()> {
    none(image, "64 bits or division: ", symbols::is_long)
}

fn none(image: &Image, what: &str, is: fn(&str) -> bool) -> Result<()> {
    let names: Vec<_> = image.symbols().into_iter().filter(|s| is(s)).collect();
    ensure(names.is_empty(), || {
        format!("{what} routines: {}", names.join(", "))
    })
}

/// No arithmetic on floats at all: neither routines nor instructions.
fn no_float(image: &Image) -> Result<()> {
    none(image, "soft double", symbols::is_double)?;
    none(image, "soft float", symbols::is_single)?;
    let found = thumb::fpu_instructions(image);
    ensure(found.is_empty(), || {
        format!(
            "{} FPU instructions, the first at {:#x}",
            found.len(),
            found[0]
        )
    })
}
