//! log₂ to about eight bits beyond the format, without a division, a branch or a look-up.
//!
//! Method: one of four short factors c, picked by compares, brings m to within 10 % of 1, exactly;
//! then ln(1 + f) = f − f²/2 + f³·P(f) with the square (in `f64` the cube too) of f's leading
//! digits exact. What is rounded is at most 2⁻⁸ of the result, so that its error is 2⁻³² (`f32`)
//! or 2⁻⁶⁴ (`f64`).
//!
//! Source: the reduction by a factor is P. T. P. Tang's, 1990, DOI 10.1145/98267.98294.

use super::format::Native;
use super::pair::Pair;
use super::poly::by_fours;
use super::table::Part;

/// The part for the significand m.
#[inline(always)]
fn part<T: Native>(m: T) -> Part<T> {
    let [first, rest @ ..] = T::TABLE.log_parts;
    rest.iter().fold(first, |part, next| {
        let above = m >= next.from;
        let choose = |a, b| T::select(above, a, b);
        Part {
            from: next.from,
            factor: choose(next.factor, part.factor),
            log: Pair {
                hi: choose(next.log.hi, part.log.hi),
                lo: choose(next.log.lo, part.log.lo),
            },
        }
    })
}

/// ln(1 + f + low) for |f| < 0.096, low a last place of f; not normalised.
#[inline(always)]
fn ln_near_one<T: Native>(f: T, low: T) -> Pair<T> {
    let head = f.cube_head();
    let tail = (f - head) + low;
    let square = head * head;
    let first = Pair::fast_two_sum(head, -(square * T::HALF));
    let series = by_fours(f, T::TABLE.log_series);
    let bend = (f + head) * T::HALF;
    let f2 = f * f;
    let Pair {
        hi: third,
        lo: third_rest,
    } = T::TABLE.third;
    if T::EXACT_CUBE {
        let cube = square * head;
        let second = Pair::fast_two_sum(first.hi, cube * third);
        let turn = (f * (f + head) + square) * (third + third_rest);
        let rest = (cube * third_rest + f2 * (f2 * series - f * low)) - tail * (bend - turn);
        Pair {
            hi: second.hi,
            lo: tail + ((first.lo + second.lo) + rest),
        }
    } else {
        Pair {
            hi: first.hi,
            lo: tail
                + (first.lo + (f2 * (f * (third + third_rest) + low + f2 * series) - tail * bend)),
        }
    }
}

/// log₂ of 2ᵉ(1 + f + low), 1 + f from 0.648 to 1.297, low a last place of f; the trailing word
/// may be as large as 2⁻¹¹ (`f32`) or 2⁻²⁵ (`f64`) of the leading one.
#[inline(always)]
pub(crate) fn log2<T: Native>(e: i32, f: T, low: T) -> Pair<T> {
    let part = part(T::ONE + f);
    let head = f.leading_half();
    // Exact: half the digits times a short factor.
    let lead = head * part.factor + (part.factor - T::ONE);
    let near = Pair::fast_two_sum(lead, (f - head) * part.factor);
    let ln = ln_near_one(near.hi, near.lo + low * part.factor);
    let Pair {
        hi: log2_e,
        lo: log2_e_rest,
    } = T::TABLE.log2_e;
    let head = ln.hi.leading_half();
    let rest = ((ln.hi - head) + ln.lo) * log2_e + (ln.hi + ln.lo) * log2_e_rest;
    let sum = Pair::fast_two_sum(T::from_i32(e) + part.log.hi, head * log2_e);
    Pair {
        hi: sum.hi,
        lo: sum.lo + (rest + part.log.lo),
    }
}
