//! Which true value each result is held against.

use super::measure::Input;
use super::op::{AT_ANGLE, AT_TAIL, Op};
use super::reference::Id;

/// Of the nine values at an angle or at a pair, those of the pair.
pub(super) const OF_PAIR: [usize; 4] = [3, 4, 7, 8];

/// Which truth a slot of `AT_ANGLE` or `AT_TAIL` is held against, and whether its sign is mirrored.
pub struct Slot {
    pub op: Op,
    pub truth: usize,
    pub negated: bool,
}

pub fn angle_slots(law: Id, solid: bool, input: Input) -> impl Iterator<Item = (usize, Slot)> {
    // A planar law's references are those of −θ.
    let order: &[usize] = if law.planar() {
        &[0, 1, 2, 3, 4, 6, 5, 8, 7, 5, 6, 7, 8]
    } else {
        &[0, 1, 2, 3, 4, 5, 6, 7, 8]
    };
    let slots = order.iter().enumerate().map(|(i, &truth)| {
        let (op, negated) = (AT_ANGLE[i], false);
        (i, Slot { op, truth, negated })
    });
    slots.filter(move |(_, s)| {
        let of_pair = input == Input::Angle || OF_PAIR.contains(&s.truth);
        of_pair && (solid || s.op != Op::PdfSolidAngle)
    })
}

pub fn tail_slots(law: Id) -> impl Iterator<Item = (usize, Slot)> {
    let planar = law.planar();
    let order = if planar {
        [3, 4, 3, 4, 5, 5]
    } else {
        [0, 1, 3, 4, 2, 5]
    };
    order.into_iter().enumerate().map(move |(i, truth)| {
        let op = AT_TAIL[i];
        let negated = planar && matches!(op, Op::WarpSin | Op::Quantile);
        (i, Slot { op, truth, negated })
    })
}
