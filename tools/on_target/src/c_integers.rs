//! What the C program has to print of the laws in integers.

use crate::c_values::{INPUTS, Lines, filled, sixteen};
use coslobe::integers::{CosPower, Fixed16Law, FixedLaw};
use coslobe::self_test::{self, InFixed, Subject};
use coslobe::{Ball, CircleArc, CircleShell, CosSin, Disk, Fixed, Fixed16, Lambert, SphereShell};
use fixed::types::{I0F16, I0F32, I1F15, I1F31, U0F16, U0F32, U16F16};
use rand_pcg::Pcg32;

/// Its lines.
pub(crate) fn expected(lines: &mut Lines) {
    q31(lines, "disk", Fixed(Disk), U0F32::to_bits);
    q31(lines, "circle_shell", Fixed(CircleShell), U0F32::to_bits);
    q31(lines, "circle_arc", Fixed(CircleArc), U0F32::to_bits);
    q31_in_space(lines, "ball", Fixed(Ball), U0F32::to_bits);
    q31_in_space(lines, "sphere_shell", Fixed(SphereShell), U0F32::to_bits);
    q31_in_space(lines, "lambert", Fixed(Lambert), U0F32::to_bits);
    let lobe = Fixed(CosPower::new(U16F16::from_bits(0x74ccd)));
    q31_in_space(lines, "cos_power", lobe, U16F16::to_bits);
    q15(lines, "disk", Fixed16(Disk));
    q15(lines, "circle_shell", Fixed16(CircleShell));
    q15(lines, "circle_arc", Fixed16(CircleArc));
    q15_in_space(lines, "ball", Fixed16(Ball));
    q15_in_space(lines, "sphere_shell", Fixed16(SphereShell));
    q15_in_space(lines, "lambert", Fixed16(Lambert));
}

fn q31_in_space<L: FixedLaw<Direction = [I1F31; 3]> + Copy>(
    lines: &mut Lines,
    law: &str,
    l: Fixed<L>,
    density: fn(L::Density) -> u32,
) where
    InFixed<Fixed<L>>: Subject,
{
    q31(lines, law, l, density);
    let bits = |d: [I1F31; 3]| d.map(|x| x.to_bits().cast_unsigned()).to_vec();
    let angle = |x: u32| I0F32::from_bits(x.cast_signed());
    lines.add(
        law,
        "pdf_solid_angle",
        "q31",
        INPUTS.map(|x| density(l.pdf_solid_angle(angle(x)))),
    );
    let warped = pairs().map(|u| bits(l.warp_direction(u.map(U0F32::from_bits))));
    lines.directions(law, "q31", warped);
    let normal = [0x4ccc_cccd, 0, -0x6666_6666].map(I1F31::from_bits);
    let around = sixteen(|rng| bits(l.sample_around(normal, rng)));
    lines.draws(law, "sample_around", "q31", around);
}

fn q15_in_space<L: Fixed16Law<Direction = [I1F15; 3]> + Copy>(
    lines: &mut Lines,
    law: &str,
    l: Fixed16<L>,
) where
    InFixed<Fixed16<L>>: Subject,
{
    q15(lines, law, l);
    let bits = |d: [I1F15; 3]| d.map(|x| x.to_bits().cast_unsigned().into()).to_vec();
    let angle = |x: u32| I0F16::from_bits(((x >> 16) as u16).cast_signed());
    let solid = INPUTS.map(|x| l.pdf_solid_angle(angle(x)).to_bits().into());
    lines.add(law, "pdf_solid_angle", "q15", solid);
    let high = |x: u32| U0F16::from_bits((x >> 16) as u16);
    let warped = pairs().map(|u| bits(l.warp_direction(u.map(high))));
    lines.directions(law, "q15", warped);
    let normal = [0x4ccd, 0, -0x6666].map(I1F15::from_bits);
    let around = sixteen(|rng| bits(l.sample_around(normal, rng)));
    lines.draws(law, "sample_around", "q15", around);
}

fn q31<L: FixedLaw + Copy>(
    lines: &mut Lines,
    law: &str,
    l: Fixed<L>,
    density: fn(L::Density) -> u32,
) where
    InFixed<Fixed<L>>: Subject,
    L::Direction: IntoIterator<Item = I1F31>,
{
    let component = |x: I1F31| x.to_bits().cast_unsigned();
    let (angle, p) = (|x: u32| I0F32::from_bits(x.cast_signed()), U0F32::from_bits);
    let pair = |at: CosSin<I1F31>| [component(at.cos), component(at.sin)];
    let mut of_number = |op: &str, f: &dyn Fn(u32) -> u32| {
        lines.add(law, op, "q31", INPUTS.map(f));
    };
    of_number("pdf", &|x| density(l.pdf(angle(x))));
    of_number("cdf", &|x| l.cdf(angle(x)).to_bits());
    of_number("sf", &|x| l.sf(angle(x)).to_bits());
    of_number("quantile", &|x| l.quantile(p(x)).to_bits().cast_unsigned());
    of_number("isf", &|x| l.isf(p(x)).to_bits().cast_unsigned());
    lines.add(
        law,
        "warp",
        "q31",
        INPUTS.into_iter().flat_map(|x| pair(l.warp(p(x)))),
    );
    lines.add(
        law,
        "warp_sf",
        "q31",
        INPUTS.into_iter().flat_map(|x| pair(l.warp_sf(p(x)))),
    );
    let mut of_pair = |op: &str, f: &dyn Fn(CosSin<I1F31>) -> u32| {
        let x = |x: u32| I1F31::from_bits(x.cast_signed());
        lines.add(
            law,
            op,
            "q31",
            pairs().map(|[cos, sin]| {
                f(CosSin {
                    cos: x(cos),
                    sin: x(sin),
                })
            }),
        );
    };
    of_pair("unwarp", &|at| l.unwarp(at).to_bits());
    of_pair("unwarp_sf", &|at| l.unwarp_sf(at).to_bits());
    of_pair("density", &|at| density(l.density(at)));
    let draw = |rng: &mut Pcg32| l.sample(rng).into_iter().map(component).collect();
    lines.draws(law, "sample", "q31", sixteen(draw));
    lines.draws(law, "fill", "q31", filled(draw));
    lines.self_test(law, "q31", self_test::fixed(l));
}

fn q15<L: Fixed16Law + Copy>(lines: &mut Lines, law: &str, l: Fixed16<L>)
where
    InFixed<Fixed16<L>>: Subject,
    L::Direction: IntoIterator<Item = I1F15>,
{
    // C's test sees a component by its 16 bits.
    let component = |x: I1F15| x.to_bits().cast_unsigned().into();
    let high = |x: u32| (x >> 16) as u16;
    let (angle, p) = (
        move |x: u32| I0F16::from_bits(high(x).cast_signed()),
        move |x: u32| U0F16::from_bits(high(x)),
    );
    let pair = |at: CosSin<I1F15>| [component(at.cos), component(at.sin)];
    let mut of_number = |op: &str, f: &dyn Fn(u32) -> u16| {
        lines.add(law, op, "q15", INPUTS.map(|x| f(x).into()));
    };
    of_number("pdf", &|x| l.pdf(angle(x)).to_bits());
    of_number("cdf", &|x| l.cdf(angle(x)).to_bits());
    of_number("sf", &|x| l.sf(angle(x)).to_bits());
    of_number("quantile", &|x| l.quantile(p(x)).to_bits().cast_unsigned());
    of_number("isf", &|x| l.isf(p(x)).to_bits().cast_unsigned());
    lines.add(
        law,
        "warp",
        "q15",
        INPUTS.into_iter().flat_map(|x| pair(l.warp(p(x)))),
    );
    lines.add(
        law,
        "warp_sf",
        "q15",
        INPUTS.into_iter().flat_map(|x| pair(l.warp_sf(p(x)))),
    );
    let mut of_pair = |op: &str, f: &dyn Fn(CosSin<I1F15>) -> u16| {
        let x = |x: u32| I1F15::from_bits(high(x).cast_signed());
        let pairs = pairs().map(|[cos, sin]| CosSin {
            cos: x(cos),
            sin: x(sin),
        });
        lines.add(law, op, "q15", pairs.map(|at| f(at).into()));
    };
    of_pair("unwarp", &|at| l.unwarp(at).to_bits());
    of_pair("unwarp_sf", &|at| l.unwarp_sf(at).to_bits());
    of_pair("density", &|at| l.density(at).to_bits());
    let draw = |rng: &mut Pcg32| l.sample(rng).into_iter().map(component).collect();
    lines.draws(law, "sample", "q15", sixteen(draw));
    lines.draws(law, "fill", "q15", filled(draw));
    lines.self_test(law, "q15", self_test::fixed(l));
}

fn pairs() -> impl Iterator<Item = [u32; 2]> {
    INPUTS
        .into_iter()
        .flat_map(|cos| INPUTS.map(|sin| [cos, sin]))
}
