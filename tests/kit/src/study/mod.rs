//! What the studies of accuracy and cost share.

pub mod cell;
pub mod count;
pub mod errors;
pub mod inputs;
