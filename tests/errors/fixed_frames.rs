//! Frames and directions around a normal in integers, against `f64`: errors by search, and what
//! normals are refused.

use coslobe::integers::FixedFrame;
use coslobe::rand_core::Rng;
use coslobe::{Ball, Disk, Fixed, Fixed16, NormalError};
use fixed::types::{I1F15, I1F31};
use kit::stats::words;

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

fn scaled(a: Vector, by: f64) -> Vector {
    a.map(|c| c * by)
}

/// A component in integers, by its units.
trait Component: Copy + PartialEq + std::fmt::Debug + Into<f64> {
    const UNIT: f64;
    fn of(x: f64) -> Self;
    fn world(normal: [Self; 3], local: [Self; 3]) -> [Self; 3];
    fn local(normal: [Self; 3], world: [Self; 3]) -> [Self; 3];
}

impl Component for I1F31 {
    const UNIT: f64 = 1.0 / 2147483648.0;
    fn of(x: f64) -> Self {
        I1F31::saturating_from_num(x)
    }
    fn world(normal: [Self; 3], local: [Self; 3]) -> [Self; 3] {
        FixedFrame::new(normal)
            .expect("a unit vector")
            .to_world(local)
    }
    fn local(normal: [Self; 3], world: [Self; 3]) -> [Self; 3] {
        FixedFrame::new(normal)
            .expect("a unit vector")
            .to_local(world)
    }
}

impl Component for I1F15 {
    const UNIT: f64 = 1.0 / 32768.0;
    fn of(x: f64) -> Self {
        I1F15::saturating_from_num(x)
    }
    fn world(normal: [Self; 3], local: [Self; 3]) -> [Self; 3] {
        FixedFrame::new(normal)
            .expect("a unit vector")
            .to_world(local)
    }
    fn local(normal: [Self; 3], world: [Self; 3]) -> [Self; 3] {
        FixedFrame::new(normal)
            .expect("a unit vector")
            .to_local(world)
    }
}

/// The axes of the frame around a normal, as `Frame` documents them.
fn axes(normal: Vector) -> [Vector; 3] {
    coslobe::Frame::from_unit(scaled(normal, 1.0 / length(normal))).axes()
}

fn unit(rng: &mut impl Rng) -> Vector {
    let mut next = || f64::from(rng.next_u32() as i32) / 2147483648.0;
    let v = [next(), next(), next()];
    // In any power of 2 beside an axis or a plane.
    let shrink = |c: f64, by: u32| c * 2f64.powi(-(by as i32 % 40));
    let words = rng.next_u32();
    let v = match words % 4 {
        0 => v,
        1 => [v[0], shrink(v[1], words >> 8), v[2]],
        2 => [shrink(v[0], words >> 8), v[1], shrink(v[2], words >> 16)],
        _ => [shrink(v[0], words >> 8), shrink(v[1], words >> 16), v[2]],
    };
    let length = length(v);
    if length > 1e-6 {
        scaled(v, 1.0 / length)
    } else {
        [0.0, 1.0, 0.0]
    }
}

/// The larger error, and what it is at.
fn worse<C: Component>(worst: &mut (f64, [[C; 3]; 2]), error: f64, at: [[C; 3]; 2]) {
    if error.is_nan() || error > worst.0 {
        *worst = (error, at);
    }
}

/// Largest errors in units of: a component to the world's and back, and a length.
fn errors<C: Component>(name: &str) -> [f64; 3] {
    let mut rng = words::pcg(name);
    let zero = [[C::of(0.0); 3]; 2];
    let mut worst = [(0.0, zero); 3];
    let ends = [-1.0, 1.0, -0.5f64.sqrt(), 0.5f64.sqrt(), 0.6, -0.8];
    for i in 0..2_000_000 {
        let mut normal = unit(&mut rng);
        if i < 3 * ends.len() {
            normal = [0.0; 3];
            normal[i % 3] = ends[i / 3];
            normal[(i + 1) % 3] = (1.0 - ends[i / 3] * ends[i / 3]).sqrt();
        }
        let (normal, local) = (normal.map(C::of), unit(&mut rng).map(C::of));
        let exact = axes(normal.map(Into::into));
        let from = local.map(Into::into);
        let world = C::world(normal, local);
        let want: Vector =
            std::array::from_fn(|j| (0..3).map(|a| exact[a][j] * from[a]).sum::<f64>());
        let off = |found: [C; 3], want: Vector| {
            let off = |(a, b): (C, f64)| (a.into() - b.clamp(C::UNIT - 1.0, 1.0 - C::UNIT)).abs();
            found.into_iter().zip(want).map(off).fold(0.0, f64::max) / C::UNIT
        };
        worse(&mut worst[0], off(world, want), [normal, local]);
        let back = C::local(normal, local);
        let want = exact.map(|axis| dot(axis, from));
        worse(&mut worst[1], off(back, want), [normal, local]);
        let long = (length(world.map(Into::into)) - length(from)).abs() / C::UNIT;
        worse(&mut worst[2], long, [normal, local]);
    }
    println!("{name}: {worst:?}");
    worst.map(|(error, _)| error)
}

#[test]
fn rotations_are_within_their_bounds() {
    let long = errors::<I1F31>("I1F31");
    let short = errors::<I1F15>("I1F15");
    assert!(
        long.iter().zip([10.0, 12.0, 9.0]).all(|(e, b)| *e <= b),
        "{long:?}"
    );
    assert!(
        short.iter().zip([3.5, 3.5, 4.0]).all(|(e, b)| *e <= b),
        "{short:?}"
    );
}

/// Around +y nothing turns, and no bit of x is lost.
#[test]
fn a_frame_around_the_axis_keeps_x() {
    fn keeps_x<C: Component>(rng: &mut impl Rng) {
        let [axis, local] = [[0.0, 1.0, 0.0], unit(rng)].map(|v| v.map(C::of));
        // No component is −1.
        let x = C::of(local[0].into().max(C::UNIT - 1.0));
        assert_eq!(C::world(axis, local)[0], x, "{local:?}");
    }
    let mut rng = words::pcg("axis");
    for _ in 0..10_000 {
        keeps_x::<I1F31>(&mut rng);
        keeps_x::<I1F15>(&mut rng);
    }
}

/// A sample with its density is the bare one, and its pair is the direction's before it was turned.
#[test]
fn samples_with_density_are_the_same() {
    let normal = [0.48, 0.6, -0.64];
    let (long, short) = (normal.map(I1F31::from_num), normal.map(I1F15::from_num));
    let [mut a, mut b, mut c] = [0; 3].map(|_: i32| words::pcg("density"));
    for _ in 0..10_000 {
        let sample = Fixed(Ball).sample_around_with_density(long, &mut a);
        assert_eq!(sample.direction, Fixed(Ball).sample_around(long, &mut b));
        let plain = Fixed(Ball).sample_with_density(&mut c);
        assert_eq!((plain.at, plain.density), (sample.at, sample.density));
        assert_eq!(plain.at.cos, plain.direction[1]);
        assert!(sample.density > 0 && sample.density == Fixed(Ball).density(sample.at));
        let [x, _, z] = plain.direction.map(f64::from);
        assert!((x.hypot(z) - f64::from(plain.at.sin)).abs() < 4.0 * I1F31::UNIT);
        let sample = Fixed16(Ball).sample_around_with_density(short, &mut a);
        assert_eq!(sample.direction, Fixed16(Ball).sample_around(short, &mut b));
        let plain = Fixed16(Ball).sample_with_density(&mut c);
        assert_eq!((plain.at, plain.density), (sample.at, sample.density));
        assert!(sample.density > 0 && sample.density == Fixed16(Ball).density(sample.at));
        let [x, _, z] = plain.direction.map(f64::from);
        assert!((x.hypot(z) - f64::from(plain.at.sin)).abs() < 3.0 * I1F15::UNIT);
    }
}

#[test]
fn samples_of_the_plane_with_density_are_the_same() {
    let [mut a, mut b] = [0; 2].map(|_: i32| words::pcg("density"));
    for _ in 0..10_000 {
        let sample = Fixed(Disk).sample_with_density(&mut a);
        assert_eq!(sample.direction, Fixed(Disk).sample(&mut b));
        assert_eq!([sample.at.sin, sample.at.cos], sample.direction);
        assert!(sample.density > 0 && sample.density == Fixed(Disk).density(sample.at));
        let sample = Fixed16(Disk).sample_with_density(&mut a);
        assert_eq!(sample.direction, Fixed16(Disk).sample(&mut b));
        assert_eq!([sample.at.sin, sample.at.cos], sample.direction);
        assert!(sample.density > 0 && sample.density == Fixed16(Disk).density(sample.at));
    }
}

fn refusals<C: Component>(slack: f64, new: impl Fn([C; 3]) -> Option<NormalError>) {
    for direction in [[0.36, -0.48, 0.8], [0.6, 0.8, 0.0], [-0.64, 0.6, 0.48]] {
        for (off, refused) in [(0.9, false), (1.2, true), (-0.9, false), (-1.2, true)] {
            let normal = scaled(direction, 1.0 + off * slack).map(C::of);
            let expected = refused.then_some(NormalError::NotUnit);
            assert_eq!(new(normal), expected, "{normal:?}");
        }
    }
    assert_eq!(new([C::of(0.0); 3]), Some(NormalError::Zero));
    assert_eq!(new([C::of(0.0), C::of(-1.0), C::of(0.0)]), None);
    assert_eq!(new([C::of(-1.0); 3]), Some(NormalError::NotUnit));
}

#[test]
fn normals_far_from_unit_are_refused() {
    refusals(2f64.powi(-20), |n: [I1F31; 3]| FixedFrame::new(n).err());
    refusals(2f64.powi(-12), |n: [I1F15; 3]| FixedFrame::new(n).err());
}

/// Any vector and any local direction is safe, and no component is −1.
#[test]
fn anything_is_safe() {
    let mut rng = words::pcg("anything");
    let corners = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX];
    for i in 0..200_000 {
        let mut next = |j: usize| {
            let word = rng.next_u32();
            let corner = corners.get((word >> 28) as usize + usize::from(i & j == 0));
            corner.copied().unwrap_or(word as i32)
        };
        let v: [i32; 6] = std::array::from_fn(&mut next);
        let [a, b] = [[v[0], v[1], v[2]], [v[3], v[4], v[5]]];
        let frame = FixedFrame::from_unit(a.map(I1F31::from_bits));
        let local = b.map(I1F31::from_bits);
        assert!(!frame.to_world(local).contains(&I1F31::MIN));
        assert!(!frame.to_local(local).contains(&I1F31::MIN));
        let short = |v: [i32; 3]| v.map(|c| I1F15::from_bits((c >> 16) as i16));
        let frame = FixedFrame::from_unit(short(a));
        assert!(!frame.to_world(short(b)).contains(&I1F15::MIN));
        assert!(!frame.to_local(short(b)).contains(&I1F15::MIN));
    }
}
