//! Frames around any vector.

use super::input::Input;
use super::measure::assert_unit;
use coslobe::{Frame, Lambert, NormalError, Spatial};
use kit::Number;

/// Axes from `Frame::new`, whose normal is itself rounded: lengths and dot products, in ulp of 1.
const AXES_ULP: f64 = 8.0;
/// to_local(to_world(d)) against a unit vector d, per component in ulp of 1.
const ROUND_TRIP_ULP: f64 = 16.0;

/// Around any vector, with a direction drawn in it.
pub(super) fn frame<T: Number>(mut input: Input) {
    let normal: [T; 3] = std::array::from_fn(|_| input.number(-1.0, 1.0));
    let mut words = input.words.uncounted();
    // No promise for a vector of any length but that it does not panic.
    let _ = Frame::from_unit(normal).to_world(normal);
    let wide = normal.map(T::wide);
    let expected = if wide.iter().any(|c| !c.is_finite()) {
        Some(NormalError::NotFinite)
    } else if wide == [0.0; 3] {
        Some(NormalError::Zero)
    } else {
        None
    };
    let frame = match Frame::new(normal) {
        Ok(frame) => frame,
        Err(error) => return assert_eq!(Some(error), expected, "{normal:?}"),
    };
    assert_eq!(None, expected, "{normal:?}");
    let axes = frame.axes().map(|axis| axis.map(T::wide));
    for axis in frame.axes() {
        assert_unit(axis, AXES_ULP);
    }
    for (a, b) in [(0, 1), (1, 2), (2, 0)] {
        let dot = dot(axes[a], axes[b]);
        assert!(
            dot.abs() <= AXES_ULP * T::ULP,
            "axes {a} and {b} of {axes:?}: {dot:?}"
        );
    }
    // Right-handed, as +x, +y, +z are: x × y = z.
    let [x, y, z] = axes;
    let cross = [
        x[1] * y[2] - x[2] * y[1],
        x[2] * y[0] - x[0] * y[2],
        x[0] * y[1] - x[1] * y[0],
    ];
    assert!(dot(cross, z) > 0.5, "{axes:?} is left-handed");
    // The middle axis points where the normal does.
    let largest = wide.iter().fold(0f64, |m, c| m.max(c.abs()));
    let scaled = wide.map(|c| c / largest);
    let along = dot(axes[1], scaled) / dot(scaled, scaled).sqrt();
    assert!(
        (along - 1.0).abs() <= AXES_ULP * T::ULP,
        "{axes:?} is not around {normal:?}"
    );

    let d: [T; 3] = Lambert.sample(&mut words);
    let world = frame.to_world(d);
    assert_unit(world, ROUND_TRIP_ULP);
    let back = frame.to_local(world);
    for (a, b) in back.into_iter().zip(d) {
        let apart = (a.wide() - b.wide()).abs();
        assert!(
            apart <= ROUND_TRIP_ULP * T::ULP,
            "{d:?} came back as {back:?}"
        );
    }
    let mut again = words.clone();
    let around = Lambert.sample_around(frame.axes()[1], &mut again);
    assert_eq!(
        around,
        frame.to_world(Lambert.sample(&mut words)),
        "sample_around"
    );
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
