//! docs/self_test.md: what the check costs and sees, as measured here.
pub const RAM: usize = 0;
