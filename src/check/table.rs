//! Limits of χ², in tenths. Made by `cargo test --test self_test -- --ignored write_limits`.

use super::limits::Row;

#[rustfmt::skip]
pub(super) const TABLE: [Row; 9] = [
    Row { freedom: 15, limits: [[8, 635], [3, 803]] },
    Row { freedom: 32, limits: [[56, 935], [34, 1128]] },
    Row { freedom: 33, limits: [[60, 951], [37, 1146]] },
    Row { freedom: 35, limits: [[68, 984], [43, 1181]] },
    Row { freedom: 37, limits: [[76, 1016], [49, 1216]] },
    Row { freedom: 39, limits: [[85, 1048], [55, 1250]] },
    Row { freedom: 41, limits: [[93, 1080], [62, 1284]] },
    Row { freedom: 43, limits: [[102, 1111], [69, 1317]] },
    Row { freedom: 63, limits: [[203, 1413], [150, 1640]] },
];
