//! The bits of every shipped scene's pixels: the same in debug and release, on every target.

use shade::cells::cells;
use shade_core::Pixel;

/// FNV-1a of the sums.
fn digest(pixels: &[Pixel<f32>]) -> u64 {
    let sums = |p: &Pixel<f32>| [p.first, p.sum, p.squares, p.rests[0], p.rests[1]].concat();
    let bytes = pixels
        .iter()
        .flat_map(sums)
        .flat_map(|x| x.to_bits().to_le_bytes());
    bytes.fold(0xCBF2_9CE4_8422_2325, |h, b| {
        (h ^ u64::from(b)).wrapping_mul(0x100_0000_01B3)
    })
}

const GOLDEN: [(&str, u64); 12] = [
    ("emitter", 0x46AC_C130_B95E_FFD7),
    ("furnace", 0x6767_D4C7_5D76_6525),
    ("gradient", 0xA5CB_13EE_B6DC_2C78),
    ("hard_shadow", 0x63EE_03F1_3477_051F),
    ("soft_shadow", 0x7D4D_403A_BC39_5D38),
    ("box", 0x7521_EB09_D14E_42AF),
    ("gloss", 0xAAD9_9BE5_2672_648D),
    ("depth_of_field", 0xC391_E478_E4C8_734D),
    ("fog", 0x3335_7164_2D86_66EF),
    ("all", 0xFAD6_1BBE_D6D9_0474),
    ("flat_lamp", 0xD8B8_1E35_E48D_61C4),
    ("flat_bounces", 0x0DAD_B796_DF86_B663),
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
