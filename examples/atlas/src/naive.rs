//! What users write by hand, for comparison.

use crate::number::Number;
use crate::reference::Shape;
use std::f64::consts::PI;

impl Shape {
    /// What a user writes first: the angle by the textbook's inverse, then its cosine.
    pub(crate) fn hand_rolled<T: Number>(self, p: T) -> T {
        let (half, pi) = (T::of(0.5), T::of(PI));
        let theta = match self {
            Shape::Disk => newton_for_disk(pi * (p - half)),
            Shape::CircleShell => (p + p - T::of(1.0)).asin(),
            Shape::CircleArc => pi * (p - half),
            Shape::Power(k) => p.powf(T::of(1.0) / (T::of(k) + T::of(1.0))).acos(),
        };
        theta.sin_cos().1
    }
}

/// θ + sin θ cos θ = rhs by Newton's method, from the one start that cannot overshoot.
fn newton_for_disk<T: Number>(rhs: T) -> T {
    let mut theta = T::of(0.0);
    for _ in 0..100 {
        let (sin, cos) = theta.sin_cos();
        let step = (theta + sin * cos - rhs) / (cos * cos + cos * cos);
        let next = theta - step;
        // Not moved, or a NaN from 0/0: θ is as near to −π/2 as the type has it.
        if next == theta || next.partial_cmp(&next).is_none() {
            break;
        }
        theta = next;
    }
    theta
}
