//! Promise: a value changes only where the changelog says so, and the tiers draw the same.

mod golden;
mod q15;
mod tiers;
