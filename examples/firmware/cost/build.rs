fn main() {
    println!("cargo::rustc-link-arg-bins=-Tboard.x");
}
