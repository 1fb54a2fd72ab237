//! Accuracy: references, sweeps and the table of allowed errors, shared by the tests and by the
//! examples that write the observed table.

pub mod bounds;
pub mod double;
pub mod format;
pub mod formula;
pub mod found;
pub mod inputs;
pub mod inverse;
pub mod long;
pub mod measure;
pub mod monotone;
pub mod op;
pub mod part;
pub mod reference;
pub mod rows;
pub mod slots;
pub mod spoiled;
pub mod subject;
pub mod tally;
pub mod truth;
pub mod truths;
pub mod values;
pub mod wide;
pub mod wide_double;
