//! The shader of examples/shade: right against closed forms, and doing no more than its scene calls for. Each
//! check is given planted faults, and has to reject them.

#[allow(dead_code)]
#[path = "../../examples/shade/cells.rs"]
mod cells;
#[allow(dead_code, unused_imports)]
#[path = "../../examples/shade/file/mod.rs"]
mod file;
#[path = "../../examples/shade/hand/mod.rs"]
mod hand;
#[allow(dead_code)]
#[path = "../../examples/shade/sets.rs"]
mod sets;

mod bad_scenes;
mod contact;
mod effects;
mod fog;
mod form_factors;
mod furnace;
mod golden;
mod mutants;
mod numbers;
mod random;
mod shadows;
mod stage;
mod sums;
mod variance;
mod words;
