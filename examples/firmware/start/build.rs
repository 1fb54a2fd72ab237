fn main() {
    println!("cargo::rustc-link-arg=-Tboard.x");
    println!("cargo::rustc-link-arg=-Tdefmt.x");
}
