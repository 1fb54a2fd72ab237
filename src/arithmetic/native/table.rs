//! The coefficients that a format brings to the kernels.

use super::pair::Pair;
use crate::Moments;

/// A power series whose leading coefficients are kept as pairs.
pub(crate) struct Series<T: 'static> {
    pub(crate) head: &'static [Pair<T>],
    pub(crate) tail: &'static [T],
}

/// Moments and coefficients of a format; `table_f32.rs` and `table_f64.rs` say what each approximates.
pub struct Table<T: 'static> {
    pub(crate) disk_moments: Moments<T>,
    pub(crate) circle_shell_moments: Moments<T>,
    pub(crate) circle_arc_moments: Moments<T>,
    pub(crate) ball_moments: Moments<T>,
    pub(crate) sphere_shell_moments: Moments<T>,
    pub(crate) lambert_moments: Moments<T>,
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
    pub(crate) sin_series: Series<T>,
    pub(crate) cos_series: Series<T>,
    pub(crate) atanh_series: Series<T>,
}
