//! The C interface as one table of laws, number types and operations, from which the header, the
//! Rust functions behind it and the list that the C test calls are made: they cannot disagree.
//!
//! The header is committed, for those who read it without Rust; `c_api`'s build script holds it to
//! [`header`]. Functions and list are made anew by every build.

mod calls;
mod draw;
mod function;
mod header;
mod number;
mod shims;
mod value;

pub use calls::calls;
pub use header::header;
pub use shims::shims;

/// A law.
#[derive(Clone, Copy)]
struct Law {
    /// In the names of C's functions.
    c: &'static str,
    rust: &'static str,
    /// Components of a direction.
    size: usize,
    what: &'static str,
}

const LAWS: [Law; 7] = [
    Law {
        c: "disk",
        rust: "Disk",
        size: 2,
        what: "uniform by area in a disk: 2 cos^2(theta) / pi per radian",
    },
    Law {
        c: "circle_shell",
        rust: "CircleShell",
        size: 2,
        what: "radial shell on a circle: cos(theta) / 2 per radian",
    },
    Law {
        c: "circle_arc",
        rust: "CircleArc",
        size: 2,
        what: "uniform by arc length on a circle: 1 / pi per radian",
    },
    Law {
        c: "ball",
        rust: "Ball",
        size: 3,
        what: "uniform by volume in a ball: 2 cos^3(theta) / pi per steradian",
    },
    Law {
        c: "sphere_shell",
        rust: "SphereShell",
        size: 3,
        what: "radial shell on a sphere: 3 cos^2(theta) / (2 pi) per steradian",
    },
    Law {
        c: "lambert",
        rust: "Lambert",
        size: 3,
        what: "uniform by area on a sphere: cos(theta) / pi per steradian, Lambert's law",
    },
    Law {
        c: "cos_power",
        rust: "CosPower",
        size: 3,
        what: "the Phong lobe: (k + 1) cos^k(theta) / (2 pi) per steradian, k >= 0",
    },
];

impl Law {
    /// Whether C holds it in a handle, which its functions take first.
    fn has_handle(self) -> bool {
        self.c == "cos_power"
    }
}
