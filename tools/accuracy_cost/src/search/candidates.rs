//! Where errors hide: beside powers of 2, 8 and 16, beside what kernels branch at, in the far
//! decades, and, for a power of the cosine, where the power is neither 0 nor 1.

use kit::Format;
use kit::accuracy::measure::Input;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

/// Inputs that are judged together.
pub(super) const BLOCK: usize = 128;

/// Beside these the kernels change their formula: where sine and cosine change places, where a
/// root's guess or an octant changes, where a series begins.
const THRESHOLDS: [f64; 10] = [
    FRAC_PI_4,
    FRAC_1_SQRT_2,
    0.5,
    0.25,
    0.125,
    0.15,
    0.75,
    0.9,
    0.375,
    1.0,
];

pub(super) fn unit(rng: &mut Pcg64) -> f64 {
    (rng.next_u64() >> 11) as f64 * 2f64.powi(-53)
}

pub(super) fn below(rng: &mut Pcg64, n: u64) -> u64 {
    rng.next_u64() % n.max(1)
}

/// ±2ʲ·m last places, m < 2⁶ and j up to the format's digits: steps of every size.
pub(super) fn step<F: Format>(rng: &mut Pcg64) -> i64 {
    let size = below(rng, F::DIGITS as u64 - 4);
    let m = below(rng, 1 << 6) as i64 - (1 << 5);
    m << size
}

/// The number `offset` last places from `bits`, kept within 0 and `top`.
pub(super) fn moved(bits: u64, offset: i64, top: u64) -> u64 {
    bits.saturating_add_signed(offset).min(top)
}

/// Bits of one input of a kind.
fn one<F: Format>(rng: &mut Pcg64, input: Input) -> u64 {
    let top = input.top::<F>();
    let largest = F::of_bits(top).wide();
    let near = |rng: &mut Pcg64, x: f64| {
        let offset = step::<F>(rng);
        moved(F::of(x).bits().min(top), offset, top)
    };
    match below(rng, 6) {
        // Every exponent alike, subnormal ones included.
        0 => below(rng, top + 1),
        1 => F::of(largest * unit(rng)).bits().min(top),
        // Crowding at the top.
        2 => top - 2f64.powf(unit(rng) * 0.9 * f64::from(F::DIGITS)) as u64,
        // Powers of 2, 8 and 16, and small multiples of them.
        3 => {
            let power = below(rng, 3 * F::DIGITS as u64) as i32;
            let every = [1, 3, 4][below(rng, 3) as usize];
            let multiple = [1.0, 1.0, 3.0, 5.0, 1.0 / 3.0][below(rng, 5) as usize];
            near(rng, multiple * 2f64.powi(-power * every))
        }
        4 => {
            let x = THRESHOLDS[below(rng, THRESHOLDS.len() as u64) as usize];
            near(rng, x)
        }
        _ => {
            // The square, cube or fourth root of what a format can hold last.
            let root = [2.0, 3.0, 4.0][below(rng, 3) as usize];
            let exponent = (f64::from(F::LEAST) - 4.0 * unit(rng)) / root;
            near(rng, 2f64.powf(exponent))
        }
    }
}

/// A block: inputs of their own, or neighbours.
pub(super) fn block<F: Format>(rng: &mut Pcg64, input: Input) -> Vec<F> {
    let top = input.top::<F>();
    if below(rng, 3) == 0 {
        let (first, apart) = (
            one::<F>(rng, input),
            1 + (step::<F>(rng).unsigned_abs() >> 6),
        );
        let at = |i: usize| moved(first, (i as u64).wrapping_mul(apart) as i64, top);
        return (0..BLOCK).map(|i| F::of_bits(at(i))).collect();
    }
    (0..BLOCK)
        .map(|_| F::of_bits(one::<F>(rng, input)))
        .collect()
}

/// Bits of an exponent of `CosPower`: drawn by its logarithm, evenly, or beside a number that is
/// special.
pub(super) fn exponent<F: Format>(rng: &mut Pcg64) -> u64 {
    let top = F::of(F::MAX_VALUE).bits();
    let x = match below(rng, 5) {
        0 => return below(rng, top + 1),
        1 => 4.0 * unit(rng),
        2 => 100.0 * unit(rng),
        3 => 10f64.powf(12.0 * unit(rng) - 6.0),
        _ => {
            let base = [
                below(rng, 64) as f64 / 2.0,
                2f64.powi(below(rng, 60) as i32 - 30),
            ];
            let bits = F::of(base[below(rng, 2) as usize]).bits();
            return moved(bits, step::<F>(rng), top);
        }
    };
    F::of(x).bits()
}

/// A block where cosᵏθ = e⁻ᶜ, c by its logarithm: elsewhere a large power is 0 or 1.
pub(super) fn block_of_power<F: Format>(rng: &mut Pcg64, input: Input, k: f64) -> Vec<F> {
    if input == Input::Tail || below(rng, 3) == 0 {
        return block(rng, input);
    }
    let top = F::of_bits(input.top::<F>()).wide();
    let mut at = || {
        let c = 2f64.powf(22.0 * unit(rng) - 12.0);
        let sin_squared = -(-2.0 * c / k.max(1e-300)).exp_m1();
        let x = match input {
            Input::Cos => (-c / k.max(1e-300)).exp(),
            Input::Sin => sin_squared.sqrt(),
            _ => sin_squared.sqrt().asin(),
        };
        F::of(x.min(top))
    };
    (0..BLOCK).map(|_| at()).collect()
}
