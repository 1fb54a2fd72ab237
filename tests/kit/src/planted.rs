//! A fault that the comparison of hashes has to find.

use crate::Sink;

/// Passes results on; of `Ball`'s number 777 it changes the last bit of one.
pub(crate) struct Planted<'a, K> {
    hit: bool,
    sink: &'a mut K,
}

impl<'a, K: Sink> Planted<'a, K> {
    pub(crate) fn at(law: &str, index: u32, sink: &'a mut K) -> Self {
        let hit = law == "Ball" && index == 777;
        Planted { hit, sink }
    }
}

impl<K: Sink> Sink for Planted<'_, K> {
    const NAMES_INPUTS: bool = K::NAMES_INPUTS;

    fn take(&mut self, operation: &'static str, bits: u64) {
        let last = matches!(operation, "cos θ" | "lambert_weight(at)");
        self.sink
            .take(operation, bits ^ u64::from(self.hit && last));
    }
}
