//! The laws, one a file, and what all of them can do.

mod angle;
mod ball;
mod circle_arc;
mod circle_shell;
mod cos_power;
mod direction;
mod disk;
mod exponent;
mod formulas;
mod lambert;
mod measure;
mod planar;
mod spatial;
mod sphere_shell;
mod support;

pub use angle::Law;
pub use ball::Ball;
pub use circle_arc::CircleArc;
pub use circle_shell::CircleShell;
pub use cos_power::CosPower;
pub use disk::Disk;
pub use exponent::ExponentError;
pub use lambert::{Lambert, Lambert as SphereArea};
pub use measure::Measure;
pub(crate) use measure::Point;
pub use planar::Planar;
pub use spatial::Spatial;
pub use sphere_shell::SphereShell;
