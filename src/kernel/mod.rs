//! Pure numeric kernels, generic over the number type: no law and no generator is known here.

pub(crate) mod atan;
pub(crate) mod cbrt;
pub(crate) mod double;
pub(crate) mod fast;
pub(crate) mod kepler;
pub(crate) mod moment;
pub(crate) mod pair;
pub(crate) mod poly;
pub(crate) mod power;
pub(crate) mod root;
pub(crate) mod select;
pub(crate) mod table;
pub(crate) mod table_f32;
pub(crate) mod table_f64;
pub(crate) mod trig;
pub(crate) mod turn;
pub(crate) mod uniform;
