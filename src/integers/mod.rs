//! The laws in integers alone (feature `fixed`): for processors without a floating-point unit.
//!
//! [`Fixed`](type@Fixed)`(Ball)` is the law [`Ball`](crate::Ball) in fixed point, with the
//! operations that [`Law`](crate::Law) has for floats under the same names;
//! [`Fixed16`](type@Fixed16)`(Ball)` has half the bits, for a third of the instructions on a
//! Cortex-M0, whose only multiply is one of 32 bits to 32. On a core with a long multiply the two
//! are nearer, and `Fixed` is the better choice unless memory decides. Their numbers are those of
//! the `fixed` crate:
//!
//! | number | `Fixed` | `Fixed16` | from | to |
//! |---|---|---|---|---|
//! | cosine, sine, direction | `I1F31` | `I1F15` | −1 + one unit | 1 − one unit |
//! | probability | `U0F32` | `U0F16` | 0 | 1 − one unit |
//! | angle, in turns | `I0F32` | `I0F16` | −½ | ½ − one unit |
//! | density, per radian or steradian | `U0F32`; `U16F16` for [`CosPower`] | `U0F16` | 0 | 1 − one unit; 65536 |
//! | exponent | `U16F16` | – | 0 | 65536 − 2⁻¹⁶ |
//! | weight of a Lambert reflector | `U16F16` | `U16F16` | 0 | 65536 − 2⁻¹⁶ |
//! | radius, distance, coordinate | any signed of 32 bits | of 16 bits | one unit | a quarter of the largest, half, half |
//!
//! The unit is that of the last place: 2⁻³¹, 2⁻³² and 2⁻¹⁶ for the types of `Fixed`, 2⁻¹⁵ and 2⁻¹⁶
//! for those of `Fixed16`. All bits of a word are used: an angle in turns wraps where the word
//! does, and no density of the six plain laws exceeds 2/π. ±1 **saturates** to one unit less, so
//! that a component can be negated; the probability 1 does too. θ lies in \[−¼, ¼\] turn in the
//! plane and \[0, ¼\] in space, both ends exact; outside it the density is 0 and the cdf 0 or 1.
//!
//! [`CosPower`] has no 16-bit form: densities (k + 1)/2π · cosᵏθ take more than 16 bits, and
//! beside θ = 1/√k the rounding of a pair alone, by half a unit, moves the density by (k + 1)/2π ·
//! √(k/e) units of 2⁻¹⁶: 50 at k = 64.
//!
//! # Errors
//!
//! In units of the last place of the result; the larger of an operation and its counterpart from
//! the other end. Those of `Fixed`:
//!
//! | | `warp` | unit length | `unwarp` | `density` | `pdf` | `cdf` | `quantile` |
//! |---|---|---|---|---|---|---|---|
//! | `Disk` | 3.5 | 2 | 5 | 2 | 4.5 | 1.5 | 1.75 |
//! | `CircleShell` | 2 | 2 | 1 | 0 | 1.5 | 1.5 | 2 |
//! | `CircleArc` | 2 | 2 | 3 | 0.5 | 0.5 | 0 | 1 |
//! | `Ball` | 2.5 | 2.5 | 5 | 3 | 4.5 | 7 | 2.5 |
//! | `SphereShell` | 3.5 | 3.5 | 4 | 2 | 4 | 6 | 2.5 |
//! | `Lambert` | 1 | 1.5 | 3 | 1.5 | 3 | 5 | 2 |
//! | `CosPower`, k ≤ 7.25 | 2.5 | 2 | | 1.01 · 2⁻¹⁶ | 1.01 · 2⁻¹⁶ | 6 | 2 |
//! | `CosPower`, k < 65536 | 2.5 | 2 | | 30 · 2⁻¹⁶ | 1.5 · 2⁻¹⁶ | 180 | 2 |
//!
//! `tests/errors/q31` asserts these bounds. `warp` was tried on **every** word; its worst
//! components and lengths:
//!
//! | | component | at | length | at |
//! |---|---|---|---|---|
//! | `Disk` | 3.143 | 0x7fdc3a9c | 1.910 | 0x16e55b45 |
//! | `CircleShell` | 1.598 | 0x73735d86 | 1.592 | 0x764b06ed |
//! | `CircleArc` | 1.515 | 0x40043f83 | 1.910 | 0x3fa352ba |
//! | `Ball` | 2.482 | 0xbf6064b5 | 2.417 | 0xff9d89d2 |
//! | `SphereShell` | 3.228 | 0xc9016ed4 | 3.021 | 0xff0b3c90 |
//! | `Lambert` | 1.000 | 0x00000000 | 1.131 | 0x7b0fe247 |
//!
//! In the other cells 7·10⁷ words (10⁵ for `CosPower`) and the corners lie within the bounds.
//! `unwarp` and `density` are judged at a pair rounded to its format. Within 64 units of θ from the
//! horizon a unit is much of a cosine, which `pdf` of `CosPower` with k < 1 feels: up to 10.7 ·
//! 2⁻¹⁶ there (k = 0x0de1 · 2⁻¹⁶ at 0x3ffffffd, the worst of every k below 3 at 52 such angles).
//!
//! Those of `Fixed16`, on **every** input, with the worst of them in hex (the probability, the
//! angle, or cos θ and sin θ):
//!
//! | | `warp` | unit length | `unwarp` | `density` | `pdf` | `cdf` | `quantile` |
//! |---|---|---|---|---|---|---|---|
//! | `Disk` | 1.69 (7daa) | 1.04 (179a) | 2.09 (5da1, 5746) | 1.26 (7e29, 159a) | 1.86 (21f6) | 0.81 (1fe1) | 0.9 (5594) |
//! | `CircleShell` | 1 (0000) | 1 (0000) | 1 (0000, 7fff) | 0 | 0.92 (21f6) | 0.92 (1e0a) | 0.98 (1e13) |
//! | `CircleArc` | 1 (0000) | 1 (0000) | 1.51 (59ff, 5b04) | 0.25 (0000, 7fff) | 0.25 (0000) | 0 | 0.5 (2ba5) |
//! | `Ball` | 1.08 (8c1f) | 1.11 (761d) | 3.52 (6817, 4a80) | 1.19 (7909, 29a3) | 2.18 (1a24) | 3.38 (1e0a) | 1.01 (cb61) |
//! | `SphereShell` | 1.38 (c752) | 1.18 (3277) | 3.32 (7fc0, 07f0) | 0.86 (7d49, 1a35) | 1.96 (1e90) | 2.81 (209c) | 1.05 (8d5f) |
//! | `Lambert` | 1 (0000) | 1.01 (57b8) | 2.43 (59c4, 5b3e) | 0.75 (7f54, 0d10) | 1.43 (3072) | 2.71 (1e0a) | 1.07 (7e68) |
//!
//! The pairs are all whose length is 1 to a unit; `unwarp` is judged at a pair's angle, `density`
//! at its cosine. Where 1 saturates, the error is 1. [`cos_sin`] is within 1 unit for all phases,
//! a square root within 0.4, a cube root within 0.5 before the last rounding. A sample's component
//! is within 1.7 units of the closed form of its words (10⁶ samples a law), its length within 1.5.
//! `quantile` and `cdf` keep the order of their arguments: those of `CircleArc`, `CircleShell` and
//! `Lambert` always, `Disk`'s and `Ball`'s cdf and `Ball`'s and `SphereShell`'s quantile but for a
//! unit here and there. `tests/errors/q15` asserts all this.
//!
//! `lambert_weight` and `distance`, with the worst input in hex: of a weight cos θ, in Q31 or Q15;
//! of a distance what the test makes radius, cosine and v of, in 16 bits cosine and v at the
//! radius 8191:
//!
//! | | weight, `Fixed` | weight, `Fixed16` | distance, `Fixed` | distance, `Fixed16` |
//! |---|---|---|---|---|
//! | `Disk` | 1.022 (0007b114) | 1.387 (7df2) | 1.053 (6c1349cd) | 1.097 (7cc0, 4398) |
//! | `CircleShell` | 0 | 0 | 0.5 | 0.5 |
//! | `CircleArc` | 0.5 | 0.541 (1435) | 0.5 | 0.5 |
//! | `Ball` | 1.513 (01694c67) | 2.701 (7f7e) | 1.141 (178e733f) | 1.090 (7daa, 4567) |
//! | `SphereShell` | 0.923 (00054b58) | 1.481 (7f7d) | 0.5 | 0.5 |
//! | `Lambert` | 0 | 0 | 0.5 | 0.5 |
//!
//! A weight w errs by that many of the larger of 2⁻¹⁶ and 2⁻²⁸ w (`Fixed16`: 2⁻¹⁴ w), on **every**
//! cosine; `CosPower`'s by 0.74 of the larger of 2⁻¹⁶ and 2⁻²⁴ w (3·10⁵ pairs for each of nine
//! exponents from 0 to 65536). A distance errs by that many units of its type, searched over
//! radii, cosines and v: of `Fixed` 3·10⁸ for `Disk` and `Ball`, 4·10⁶ for the others; of
//! `Fixed16` at four radii, for `Disk` with **every** cosine and v. `tests/errors` asserts all
//! this, with a margin. A point's coordinates are the distance times the direction, and one unit
//! more.
//!
//! # Words of randomness
//!
//! [`sample`](Integers::sample) takes words by `next_u32`, always as many, and no rejection:
//!
//! | law, in `Fixed` | words | cos θ | azimuth or sign |
//! |---|---|---|---|
//! | `Lambert`, `SphereShell`, `Ball` | 3, 4, 5 | the largest of all but the last | the last |
//! | `CosPower` | 3 | u^(1/(k+1)), u of the first two, 64 bits | the third |
//! | `Disk` | 3 | ∛(2p) is the largest, p the nearer tail | the first one's top bit |
//! | `CircleShell` | 2 | √(v (2 − v)), v of 63 bits | the top bit |
//! | `CircleArc` | 1 | of ± that many quarter turns, 31 bits | the top bit |
//!
//! | law, in `Fixed16` | words | cos θ | azimuth or sign |
//! |---|---|---|---|
//! | `Lambert` | 2 | the larger half of the first | the second |
//! | `SphereShell` | 2 | the largest of three halves | the second one's upper half |
//! | `Ball` | 3 | the largest of four halves | the third |
//! | `Disk` | 2 | ∛(2p) is the largest of three halves | the second one's top bit |
//! | `CircleShell` | 1 | √(v (2 − v)), v of 31 bits | the top bit |
//! | `CircleArc` | 1 | of ± that many quarter turns, 31 bits | the top bit |
//!
//! U^(1/n) is the largest of n uniform numbers: so no root is taken of a word, and cos θ is as
//! fine as its format, down to 2⁻³¹ (for `Ball` that has probability 2⁻¹²⁴). Beside the axis it
//! continues with the bits of the words that lost, to 2⁻⁶⁴ (`Fixed16`: of the halves, to 2⁻³²):
//! sin θ has no grid there but that of its own format. `SphereShell` has 2¹⁶ azimuths in
//! `Fixed16`, the others in space 2¹⁹. Signs and azimuths come from a word's high bits, since the
//! low ones of common generators are poor. Whatever the generator gives, cos θ > 0 and the
//! direction has unit length to 4 units (`Fixed16`: 2).
//!
//! A point ([`sample_point`](Integers::sample_point)) takes these words, then, of the disk and ball
//! alone, those of its distance: the larger of two words or the largest of three, of halves in
//! `Fixed16`, which take one word or two.
//!
//! # What is where
//!
//! | operation | floats | `Fixed` | `Fixed16` |
//! |---|---|---|---|
//! | `warp`, `warp_sf`, `unwarp`, `unwarp_sf`, `density`, `pdf`, `cdf`, `sf`, `quantile`, `isf` | all | all | not `CosPower` |
//! | `sample`, `try_sample` | all | all | not `CosPower` |
//! | `pdf_solid_angle`, `warp_direction`, `unwarp_direction`, `sample_around` | in space | in space | in space |
//! | `sample_with_density`, `lambert_weight` | all | all | not `CosPower` |
//! | `sample_around_with_density` | in space | in space | in space |
//! | points: `distance`, `sample_distance`, `sample_point` | not `CosPower` | not `CosPower` | not `CosPower` |
//! | density of a point, and its logarithm | not `CosPower` | no: 1/(πρ²) and 3/(4πρ³) have no fixed scale, and inside the disk or ball they are constants; of a shell it is `pdf` | no |
//! | [`Frame`](crate::Frame), [`FixedFrame`] | yes | yes | yes |
//! | the power-on self-test, `Distribution`, `heapless`, `serde`, `defmt` | yes | yes | yes |
//! | `ln_pdf`, `moments`, balance and power heuristics | yes | no: a logarithm or an entropy has no fixed scale | no |
//! | slices | yes | no: nothing vectorises on the cores these are for | no |
//!
//! # Recipes
//!
//! Results are as near as the tables above say; there is no rounding mode to choose. Conversions
//! are the `fixed` crate's: from a float to the nearest, from a longer number down, and what does
//! not fit **panics** where overflow checks are on: 1 is no `U0F32` and no `I1F31`. Write
//! `saturating_from_num`.
//!
//! ```
//! use fixed::types::{I0F32, I1F31, I32F32, U0F32};
//! let one = U0F32::saturating_from_num(1.0); // not from_num, which panics
//! let normal = [0.0f32, 1.0, 0.0].map(I1F31::saturating_from_num);
//! assert_eq!((one, normal[1]), (U0F32::MAX, I1F31::MAX));
//! // Degrees and radians to turns and back.
//! let turns = I0F32::from_num(I32F32::from_num(30) / 360);
//! let radians: f32 = turns.to_num::<f32>() * core::f32::consts::TAU;
//! assert!((radians - 30f32.to_radians()).abs() < 1e-6);
//! ```
//!
//! An angle in turns, `I0F32`, has the bits of the q31 angle of STM32's CORDIC unit, in which ±1
//! stands for ±π: both fill the word with one turn.
//!
//! Glob imports of this crate and of the crate `fixed` stand side by side. Of the two `CosPower`s
//! that of integers is named by its module; each in the place of the other is an error that says
//! so:
//!
//! ```
//! use coslobe::*;
//! use fixed::{types::*, *};
//! let mut rng = from_fn(|| 0x9E37_79B9);
//! let lobe = integers::CosPower::new(U16F16::from_num(20));
//! let ray: [I1F31; 3] = Fixed(lobe).sample(&mut rng);
//! # let _ = ray;
//! ```
//!
//! # Cost
//!
//! Instructions, flash, stack and words of every operation on Cortex-M0, M3, M4F and RV32IMC stand
//! in `docs/measured/firmware_cost.md` of the repository. Maxima are cheaper than roots: a whole
//! sample with its azimuth costs what `warp` takes for θ alone. The 64-bit product, one
//! instruction on the larger cores, is four products on Cortex-M0, with the same bits; `Fixed16`
//! has none.
//!
//! ```
//! use coslobe::{Fixed, Fixed16, Lambert};
//! use fixed::types::{I1F15, I1F31, U0F16, U0F32};
//! let mut rng = rand_pcg::Pcg32::new(1, 1);
//! // [sin θ cos φ, cos θ, sin θ sin φ]
//! let [x, y, z]: [I1F31; 3] = Fixed(Lambert).sample(&mut rng);
//! let short: [I1F15; 3] = Fixed16(Lambert).sample(&mut rng);
//! assert!(y > 0 && short[1] > 0);
//! let at = Fixed(Lambert).warp(U0F32::from_num(0.25));
//! assert!((at.sin.to_num::<f32>() - 0.5).abs() < 1e-9);
//! assert_eq!(Fixed16(Lambert).warp(U0F16::from_num(0.25)).sin, I1F15::from_num(0.5));
//! # let _ = (x, z);
//! ```

mod ball;
mod circle_arc;
mod circle_shell;
mod cos_power;
mod disk;
mod drawn;
mod format;
mod frame;
mod kernel;
mod lambert;
mod law;
mod operations;
mod place;
mod planar;
mod planes;
mod point;
mod q15;
mod q31;
mod spatial;
mod sphere_shell;
mod tails;
mod weight;

pub use cos_power::CosPower;
pub(crate) use format::{Component, Format};
pub use frame::FixedFrame;
pub(crate) use law::Formulas;
pub use operations::{Fixed, Fixed16, Integers, cos_sin};
pub use planes::{
    Fixed16Law, Fixed16Planar, Fixed16Spatial, Fixed16Tangent, FixedLaw, FixedPlanar, FixedSpatial,
    FixedTangent,
};
pub use point::FixedRadius;
