//! One statistical harness for every law and number type, shared by the test files beside it.
// Each test file compiles this module for itself and uses its own part of it.

pub mod chi2;
pub mod claim;
pub mod harness;
pub mod ks;
pub mod mean;
pub mod measures;
pub mod report;
pub mod words;
