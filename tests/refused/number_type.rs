//! says: `u32` is not a number type that the laws work in
//! says: integers are served by `Fixed(law)` and `Fixed16(law)`
fn main() {
    let _ = coslobe::Law::<u32>::pdf(&coslobe::Ball, 3);
}
