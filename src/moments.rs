//! Exact moments, for checking estimators.

/// Exact moments of a law, correctly rounded for the six laws without a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Moments<T> {
    /// E\[cos θ\].
    pub mean_cos: T,
    /// Var\[cos θ\].
    pub var_cos: T,
    /// E\[θ\] in radians; 0 for planar laws.
    pub mean_theta: T,
    /// Var\[θ\] in rad².
    pub var_theta: T,
    /// Differential entropy −E\[ln p\] in nats, p per radian (2D) or per steradian (3D).
    pub entropy: T,
}

impl<T> Moments<T> {
    pub(crate) fn map<U>(self, f: impl Fn(T) -> U) -> Moments<U> {
        Moments {
            mean_cos: f(self.mean_cos),
            var_cos: f(self.var_cos),
            mean_theta: f(self.mean_theta),
            var_theta: f(self.var_theta),
            entropy: f(self.entropy),
        }
    }
}
