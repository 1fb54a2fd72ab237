//! Promise: no result errs by more than `docs/bounds.md`, or its own documentation, allows.

mod arb;
mod fixed_directions;
mod fixed_frames;
mod frames_and_weights;
mod moments;
mod planted;
mod points;
mod precise_directions;
mod precise_points;
mod precise_roundings;
mod precise_tiny;
mod q15;
mod q31;
mod references;
mod sweeps;
mod worst_inputs;
