//! says: Ball` is not a law in the plane
fn main() {
    let _: [f32; 2] = coslobe::Planar::sample(&coslobe::Ball, &mut coslobe::from_fn(|| 7));
}
