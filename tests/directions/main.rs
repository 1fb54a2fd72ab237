//! Promise: a sample is a unit vector inside the open support, with a positive finite density.

mod fast;
mod with_density;
