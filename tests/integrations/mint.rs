//! Conversions.

use ::mint::{ColumnMatrix3, Vector2};
use coslobe::{CosSin, Frame};

#[test]
fn a_pair_is_a_vector_in_the_axes_of_the_paper() {
    let at = CosSin {
        cos: 0.6f32,
        sin: -0.8,
    };
    let v = Vector2::from(at);
    assert_eq!([v.x, v.y], [-0.8, 0.6]);
    assert_eq!(CosSin::from(v), at);
}

#[test]
fn a_frame_is_the_matrix_that_takes_local_to_world() {
    let frame = Frame::new([1.0, -2.0, 3.0f64]).unwrap();
    let m: [[f64; 3]; 3] = ColumnMatrix3::from(frame).into();
    assert_eq!(m, frame.axes());
    let local = [0.25, 0.5, -0.75];
    let product: [f64; 3] =
        core::array::from_fn(|i| local[0] * m[0][i] + local[1] * m[1][i] + local[2] * m[2][i]);
    assert_eq!(product, frame.to_world(local));
}
