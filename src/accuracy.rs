#![doc = include_str!("../docs/bounds.md")]
#![doc = include_str!("../docs/accuracy_cost.md")]
