//! `mint`: directions and frames as the vectors and matrices that maths libraries exchange.

use crate::{CosSin, Frame, Real};
use mint::{ColumnMatrix3, Vector2};

/// (x, y) = (sin θ, cos θ): the axes of the paper and of [`Planar::sample`](crate::Planar::sample),
/// in which θ is the angle from +y.
///
/// ```
/// let at = coslobe::CosSin { cos: 0.8, sin: 0.6 };
/// let v = mint::Vector2::from(at);
/// assert_eq!((v.x, v.y), (0.6, 0.8));
/// ```
impl<T> From<CosSin<T>> for Vector2<T> {
    #[inline]
    fn from(at: CosSin<T>) -> Self {
        Vector2 {
            x: at.sin,
            y: at.cos,
        }
    }
}

/// sin θ = x, cos θ = y; the vector's length is kept as it is.
impl<T> From<Vector2<T>> for CosSin<T> {
    #[inline]
    fn from(v: Vector2<T>) -> Self {
        CosSin { cos: v.y, sin: v.x }
    }
}

/// The axes as columns: the matrix takes a local direction to the world, as [`Frame::to_world`].
///
/// ```
/// let frame = coslobe::Frame::new([0.0, 0.0, 2.0f32])?;
/// let m = mint::ColumnMatrix3::from(frame);
/// assert_eq!(<[f32; 3]>::from(m.y), [0.0, 0.0, 1.0]); // the normal
/// # Ok::<(), coslobe::NormalError>(())
/// ```
impl<T: Real> From<Frame<T>> for ColumnMatrix3<T> {
    #[inline]
    fn from(frame: Frame<T>) -> Self {
        let [x, y, z] = frame.axes();
        ColumnMatrix3 {
            x: x.into(),
            y: y.into(),
            z: z.into(),
        }
    }
}
