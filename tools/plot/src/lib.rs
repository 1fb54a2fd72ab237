//! Figures, and the files that studies write.

pub mod axis;
pub mod canvas;
pub mod label;
pub mod output;
pub mod panel;
