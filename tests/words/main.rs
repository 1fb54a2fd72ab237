//! Promise: the words of randomness become the documented uniforms, and results that are functions
//! of them.

mod q15;
mod samples;
mod uniforms;
