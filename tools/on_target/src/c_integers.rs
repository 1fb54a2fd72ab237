//! What the C program has to print of the laws in integers.

use crate::c_values::INPUTS;
use coslobe::fixed::{CosPower, FixedLaw};
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Fixed, Lambert, SphereShell};
use fixed::types::{I0F32, I1F31, U0F32, U16F16};
use rand_pcg::Pcg32;

/// Its lines.
pub(crate) fn expected(out: &mut String, rng: &mut Pcg32) {
    law(out, "disk", Fixed(Disk), rng, U0F32::to_bits);
    law(out, "circle_shell", Fixed(CircleShell), rng, U0F32::to_bits);
    law(out, "circle_arc", Fixed(CircleArc), rng, U0F32::to_bits);
    law(out, "ball", Fixed(Ball), rng, U0F32::to_bits);
    law(out, "sphere_shell", Fixed(SphereShell), rng, U0F32::to_bits);
    law(out, "lambert", Fixed(Lambert), rng, U0F32::to_bits);
    let lobe = CosPower::new(U16F16::from_bits(0x74ccd));
    law(out, "cos_power", Fixed(lobe), rng, U16F16::to_bits);
}

fn law<L: FixedLaw>(
    out: &mut String,
    name: &str,
    law: Fixed<L>,
    rng: &mut Pcg32,
    density: fn(L::Density) -> u32,
) where
    L::Direction: AsRef<[I1F31]>,
{
    let mut line = |words: &[u32]| {
        out.push_str(name);
        out.push_str(" q31");
        for word in words {
            out.push_str(&format!(" {word:08x}"));
        }
        out.push('\n');
    };
    let direction = law.sample(rng);
    let words: Vec<u32> = direction
        .as_ref()
        .iter()
        .map(|c| c.to_bits() as u32)
        .collect();
    line(&words);
    for x in INPUTS {
        let at = law.warp(U0F32::from_bits(x));
        let CosSin { cos, sin } = at;
        line(&[
            x,
            cos.to_bits() as u32,
            sin.to_bits() as u32,
            density(law.density(at)),
            law.cdf(I0F32::from_bits(x as i32)).to_bits(),
            law.quantile(U0F32::from_bits(x)).to_bits() as u32,
        ]);
    }
}
