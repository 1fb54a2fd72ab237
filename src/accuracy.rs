#![doc = include_str!("../docs/bounds.md")]
#![doc = include_str!("../docs/measured/accuracy_cost.md")]
