//! Every public type can be logged.

use coslobe::{
    Ball, CircleArc, CircleShell, CosPower, CosSin, Disk, ExponentError, Fast, Frame, Lambert,
    Measure, Moments, NormalError, Precise, Radius, RadiusError, SphereShell, Tails, self_test,
};

/// Only its type is checked: running `Format` needs a logger, which a host has not.
fn is_format<T: ::defmt::Format>() {}

#[test]
fn public_types_can_be_logged() {
    is_format::<(Disk, CircleShell, CircleArc)>();
    is_format::<(Ball, SphereShell, Lambert)>();
    is_format::<(CosPower<f32>, CosPower<f64>)>();
    is_format::<(CosSin<f32>, Tails<f64>, Moments<f32>)>();
    is_format::<(Radius<f32>, Frame<f32>, Measure)>();
    is_format::<(Precise<f32>, CosPower<Precise<f64>>)>();
    is_format::<(Fast<f32>, CosPower<Fast<f32>>, CosSin<Fast<f32>>)>();
    is_format::<(Precise<f64>, Tails<Precise<f32>>, Radius<Fast<f32>>)>();
    is_format::<(ExponentError, RadiusError, NormalError)>();
    #[cfg(feature = "fixed")]
    is_format::<(coslobe::Fixed<Ball>, coslobe::Fixed16<Disk>)>();
    is_format::<(
        self_test::Report,
        self_test::Fault,
        self_test::Alarm,
        self_test::Place,
    )>();
}
