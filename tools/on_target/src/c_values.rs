//! What the C program has to print: the same calls, made in Rust.

use crate::c_integers;
use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, CosSin, Disk, Lambert, Law, Planar, Spatial,
    SphereShell,
};
use rand_pcg::Pcg32;

/// As in c/main.c.
pub(crate) const INPUTS: [u32; 19] = [
    0x0000_0000,
    0x8000_0000,
    0x0000_0001,
    0x1e3c_e508,
    0x38d1_b717,
    0x3dcc_cccd,
    0x3e80_0000,
    0x3f00_0000,
    0x3f19_999a,
    0x3f7f_ffff,
    0x3f80_0000,
    0x3f80_0001,
    0x3fc9_0fda,
    0x3fc9_0fdb,
    0xbf00_0000,
    0xbfc9_0fda,
    0x7f80_0000,
    0xff80_0000,
    0x7fc0_0000,
];

/// The whole output.
pub(crate) fn expected() -> String {
    let mut out = String::new();
    let mut rng = Pcg32::new(2024, 1);
    planar(&mut out, "disk", Disk, &mut rng);
    planar(&mut out, "circle_shell", CircleShell, &mut rng);
    planar(&mut out, "circle_arc", CircleArc, &mut rng);
    spatial(&mut out, "ball", Ball, &mut rng);
    spatial(&mut out, "sphere_shell", SphereShell, &mut rng);
    spatial(&mut out, "lambert", Lambert, &mut rng);
    cos_power(&mut out, 7.3, &mut rng);
    cos_power(&mut out, -1.0, &mut rng);
    c_integers::expected(&mut out, &mut rng);
    out + "refused as documented\n"
}

fn line(out: &mut String, name: &str, values: impl IntoIterator<Item = f32>) {
    out.push_str(name);
    for x in values {
        match x.is_nan() {
            true => out.push_str(" NaN"),
            false => out.push_str(&format!(" {:08x}", x.to_bits())),
        }
    }
    out.push('\n');
}

fn planar(out: &mut String, name: &str, law: impl Planar<f32>, rng: &mut Pcg32) {
    for _ in 0..8 {
        line(out, name, law.sample(rng));
    }
    evaluations(out, name, law);
}

fn spatial(out: &mut String, name: &str, law: impl Spatial<f32>, rng: &mut Pcg32) {
    for _ in 0..8 {
        line(out, name, law.sample(rng));
    }
    evaluations(out, name, law);
}

fn evaluations(out: &mut String, name: &str, law: impl Law<f32>) {
    for x in INPUTS.map(f32::from_bits) {
        let at = law.warp(x);
        let pair = CosSin {
            cos: x,
            sin: f32::from_bits(0x3f19_999a),
        };
        let densities = [law.density(at), law.density(pair)];
        let values = [x, at.cos, at.sin].into_iter().chain(densities);
        line(out, name, values.chain([law.cdf(x), law.quantile(x)]));
    }
}

fn cos_power(out: &mut String, k: f32, rng: &mut Pcg32) {
    let law = CosPower::new(k).ok();
    for x in INPUTS.map(f32::from_bits) {
        let values = law.map_or([f32::NAN; 5], |law| {
            let at = law.warp(x);
            [at.cos, at.sin, law.density(at), law.cdf(x), law.quantile(x)]
        });
        line(out, "cos_power", [k, x].into_iter().chain(values));
    }
    if let Some(law) = law {
        line(out, "cos_power", law.sample(rng));
    }
}
