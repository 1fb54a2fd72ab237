//! The coefficients that a format brings to the kernels.

use super::pair::Pair;

/// Coefficients of a format; `coefficients_f32.rs` and `coefficients_f64.rs` say what each
/// approximates.
pub struct Table<T: 'static> {
    pub(crate) sin: &'static [T],
    pub(crate) cos: &'static [T],
    pub(crate) sin_turn: &'static [T],
    pub(crate) cos_turn: &'static [T],
    pub(crate) kepler_tail: &'static [T],
    pub(crate) kepler_centre: &'static [T],
    pub(crate) disk_tail: &'static [T],
    pub(crate) disk_tail_of_cos: &'static [T],
    pub(crate) disk_centre_of_sin: &'static [T],
    pub(crate) atan: &'static [T],
    pub(crate) cosine_integral: &'static [T],
    pub(crate) angle_integral: &'static [T],
    pub(crate) atanh: &'static [T],
    pub(crate) exp2_bend: &'static [T],
    pub(crate) log_series: &'static [T],
    pub(crate) sine_tail: &'static [T],
    pub(crate) log_parts: [Part<T>; 4],
    pub(crate) log_turn: T,
    pub(crate) log2_e: Pair<T>,
    pub(crate) ln_2: Pair<T>,
    pub(crate) third: Pair<T>,
    pub(crate) half_pi_rest: T,
    pub(crate) sine_head: &'static [Pair<T>],
}

/// A factor c for significands from `from` on, and log₂ 1/c, whose leading part is short.
#[derive(Clone, Copy)]
pub(crate) struct Part<T> {
    pub(crate) from: T,
    pub(crate) factor: T,
    pub(crate) log: Pair<T>,
}
