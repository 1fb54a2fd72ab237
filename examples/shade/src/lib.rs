//! What a path tracer on `coslobe` is made of beside its core: scene files, the scenes that ship,
//! shaders written by hand for some of them, and random ones.

pub mod cells;
pub mod file;
pub mod hand;
pub mod random;
pub mod sets;
