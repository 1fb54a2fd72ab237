//! Figures.

pub mod axis;
pub mod canvas;
pub mod label;
pub mod panel;
