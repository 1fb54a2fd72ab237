//! The laws in 16-bit fixed point (feature `fixed`): for a Cortex-M0, whose only multiply is one of 32 bits to 32.
//!
//! [`Fixed16`]`(Ball)` is the law [`Ball`](crate::Ball) with the operations of [`Fixed`](crate::Fixed) under the same
//! names, in half the bits. A direction costs a third of `Fixed`'s on a Cortex-M0; on a core with a long multiply the two are
//! nearer, and `Fixed` is the better choice unless memory decides. Its numbers are those of the `fixed` crate:
//!
//! | number | type | from | to | unit |
//! |---|---|---|---|---|
//! | cosine, sine, direction | `I1F15` | −1 + 2⁻¹⁵ | 1 − 2⁻¹⁵ | 2⁻¹⁵ |
//! | probability | `U0F16` | 0 | 1 − 2⁻¹⁶ | 2⁻¹⁶ |
//! | angle, in turns | `I0F16` | −½ | ½ − 2⁻¹⁶ | 2⁻¹⁶ |
//! | density, per radian or steradian | `U0F16` | 0 | 1 − 2⁻¹⁶ | 2⁻¹⁶ |
//!
//! As in [`fixed`](crate::fixed), ±1 **saturates** to ±(1 − 2⁻¹⁵) and the probability 1 to 1 − 2⁻¹⁶; θ lies in \[−¼, ¼\] turn in
//! the plane and \[0, ¼\] in space, both ends exact; outside it the density is 0 and the cdf 0 or 1. All products are of 16 by 16
//! bits: no 64-bit product, no division, no table, no loop.
//!
//! [`CosPower`](crate::fixed::CosPower) has no 16-bit form: densities (k + 1)/2π · cosᵏθ take more than 16 bits, and beside θ = 1/√k
//! the rounding of a pair alone, by half a unit, moves the density by (k + 1)/2π · √(k/e) units of 2⁻¹⁶: 50 at k = 64.
//!
//! # Errors
//!
//! In units of the last place of the result (2⁻¹⁵ for components, 2⁻¹⁶ for probabilities, turns and densities), on **every**
//! input, with the worst of them in hex (the probability, the angle, or cos θ and sin θ); the larger of an operation and its
//! counterpart from the other end:
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
//! The pairs are all whose length is 1 to a unit; `unwarp` is judged at a pair's angle, `density` at its cosine. Where 1 saturates, the error is 1. [`cos_sin`] is within
//! 1 unit for all phases, a square root within 0.4, a cube root within 0.5 before the last rounding. A sample's component is within 1.7
//! units of the closed form of its words (10⁶ samples a law), its length within 1.5.
//! `quantile` and `cdf` keep the order of their arguments: those of `CircleArc`, `CircleShell` and `Lambert` always, `Disk`'s and
//! `Ball`'s cdf and `Ball`'s and `SphereShell`'s quantile but for a unit here and there.
//! `tests/fixed16` asserts all this.
//!
//! # Words of randomness
//!
//! [`Fixed16::sample`] takes words by `next_u32`, always as many, and no rejection:
//!
//! | law | words | cos θ | azimuth or sign |
//! |---|---|---|---|
//! | `Lambert` | 2 | the larger half of the first | the second |
//! | `SphereShell` | 2 | the largest of three halves | the last half |
//! | `Ball` | 3 | the largest of four halves | the third |
//! | `Disk` | 2 | ∛(2p) is the largest of three halves, p the nearer tail | the top bit of the last half |
//! | `CircleShell` | 1 | √(v (2 − v)), v of 32 bits | its lowest bit |
//! | `CircleArc` | 1 | of ± that many quarter turns | its lowest bit |
//!
//! U^(1/n) is the largest of n uniform numbers, so that no root is taken for cos θ. Beside the axis it continues with the bits of the halves that
//! lost, to 2⁻³²: sin θ = √(1 − cos²θ) has no grid there but that of its own format. `SphereShell` has 2¹⁶ azimuths, the others in space 2¹⁹.
//! Whatever the generator gives, cos θ > 0 and the direction has unit length to 2 units.
//!
//! # Cost
//!
//! Instructions of one `sample`, Marsaglia's xorshift32 included / PCG32 included, bytes of flash with the former, bytes
//! of stack, and in brackets what [`Fixed`](crate::Fixed) takes with xorshift32 (Rust 1.95, `opt-level = 3`; `python3 tools/fixed_cost.py` counts all operations):
//!
//! | | Cortex-M0 | flash | stack | Cortex-M3 | Cortex-M4F |
//! |---|---|---|---|---|---|
//! | `Lambert` | 165 / 262 (514) | 404 (1148) | 36 (64) | 103 / 127 (176) | 106 / 138 (173) |
//! | `SphereShell` | 177 / 276 (525) | 432 (1172) | 36 (64) | 111 / 135 (182) | 113 / 145 (179) |
//! | `Ball` | 183 / 328 (537) | 472 (1208) | 36 (64) | 119 / 153 (188) | 119 / 158 (185) |
//! | `Disk` | 152 / 252 (539) | 376 (708) | 28 (80) | 113 / 137 (148) | 115 / 145 (137) |
//! | `CircleShell` | 112 / 162 (234) | 304 (556) | 36 (48) | 70 / 83 (99) | 70 / 85 (99) |
//! | `CircleArc` | 77 / 127 (231) | 188 (508) | 28 (52) | 56 / 70 (70) | 58 / 72 (72) |
//!
//! Other operations on Cortex-M0, likewise:
//!
//! | | `warp` | `unwarp` | `density` | `pdf` | `cdf` | `quantile` |
//! |---|---|---|---|---|---|---|
//! | `Lambert` | 162 (329) | 24 (34) | 19 (32) | 69 (262) | 71 (258) | 201 (525) |
//! | `SphereShell` | 257 (648) | 30 (60) | 27 (51) | 71 (283) | 76 (281) | 296 (844) |
//! | `Ball` | 264 (577) | 30 (86) | 30 (71) | 75 (300) | 76 (318) | 302 (773) |
//! | `Disk` | 195 (771) | 100 (279) | 23 (47) | 70 (261) | 80 (260) | 148 (566) |
//! | `CircleShell` | 117 (221) | 20 (10) | 8 (7) | 63 (223) | 63 (230) | 169 (428) |
//! | `CircleArc` | 76 (234) | 87 (226) | 9 (8) | 12 (11) | 22 (16) | 22 (16) |
//!
//! The maximum is cheaper than a root here too: `warp` takes one or two roots of a word for θ alone, and costs as much as a whole
//! sample or more. The largest stack of any operation on any of the three cores is 76 bytes with xorshift32.
//!
//! ```
//! use coslobe::{Fixed16, Lambert};
//! use fixed::types::{I1F15, U0F16};
//! let mut rng = rand_pcg::Pcg32::new(1, 1);
//! let [x, y, z]: [I1F15; 3] = Fixed16(Lambert).sample(&mut rng); // [sin θ cos φ, cos θ, sin θ sin φ]
//! assert!(y > 0);
//! let at = Fixed16(Lambert).warp(U0F16::from_num(0.25));
//! assert_eq!(at.sin, I1F15::from_num(0.5));
//! # let _ = (x, z);
//! ```
//!
mod format;
mod kernel;
mod operations;
mod words;

pub use operations::{Fixed16, Fixed16Law, cos_sin};
