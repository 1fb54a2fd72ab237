//! What a path tracer on `coslobe` is made of beside its core: scene files, the scenes that ship, and shaders
//! written by hand for some of them.

pub mod cells;
pub mod file;
pub mod hand;
pub mod sets;
