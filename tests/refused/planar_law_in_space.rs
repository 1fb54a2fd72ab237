//! says: Disk` is not a law in space
//! says: the laws in space are
fn main() {
    let _ = coslobe::Spatial::sample_around(&coslobe::Disk, [0.0f32, 1.0, 0.0], &mut coslobe::from_fn(|| 7));
}
