//! The shader: right against closed forms, and doing no more than its scene calls for. Each
//! check is given planted faults, and has to reject them.

mod bad_scenes;
mod contact;
mod corners;
mod effects;
mod fog;
mod form_factors;
mod furnace;
mod golden;
mod leaks;
mod mutants;
mod numbers;
mod shadows;
mod stage;
mod sums;
mod variance;
mod words;
