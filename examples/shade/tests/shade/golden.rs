//! The bits of every shipped scene's pixels: the same in debug and release, on every target.

use shade::cells::cells;
use shade_core::Pixel;

/// FNV-1a of the sums.
fn digest(pixels: &[Pixel<f32>]) -> u64 {
    let sums = |p: &Pixel<f32>| [p.first, p.sum, p.squares].concat();
    let bytes = pixels
        .iter()
        .flat_map(sums)
        .flat_map(|x| x.to_bits().to_le_bytes());
    bytes.fold(0xCBF2_9CE4_8422_2325, |h, b| {
        (h ^ u64::from(b)).wrapping_mul(0x100_0000_01B3)
    })
}

const GOLDEN: [(&str, u64); 12] = [
    ("emitter", 0x401C_6132_47B6_26D7),
    ("furnace", 0x430D_6A32_5558_5125),
    ("gradient", 0x5712_12C2_9F1D_9918),
    ("hard_shadow", 0x22E6_40B0_3D39_E3BE),
    ("soft_shadow", 0x59CE_8F7D_EDFD_2B8E),
    ("box", 0xBCFF_99CE_6095_D3E9),
    ("gloss", 0xC3C0_6D91_BA2C_4B6A),
    ("depth_of_field", 0x488C_771E_64D4_2703),
    ("fog", 0xA4C4_B91B_B490_2FD7),
    ("all", 0x01E2_DBBB_8C70_5F1B),
    ("flat_lamp", 0x2B8D_66C2_451D_36F0),
    ("flat_bounces", 0x513D_43F3_3484_7071),
];

#[test]
fn bits_have_not_changed() {
    let needed = cells().into_iter().filter(|c| c.way == "needed");
    let have: Vec<(&str, u64)> = needed.map(|c| (c.scene, digest(&(c.pixels)()))).collect();
    assert!(have == GOLDEN, "{have:#x?}");
    // A planted bit.
    let mut pixel = Pixel::default();
    let before = digest(&[pixel]);
    pixel.sum[1] = f32::from_bits(1);
    assert_ne!(digest(&[pixel]), before);
}
