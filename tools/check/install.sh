# What the steps of ./check need, and where it comes from. Sourced by ./check.

# Prints why a need cannot be met; nothing if it is.
obtain() {
  case $1 in
    format) component rustfmt ;;
    clippy) component clippy ;;
    msrv) local rust; for rust in $(msrvs); do toolchain "$rust"; done ;;
    nightly) toolchain nightly ;;
    miri) toolchain nightly && rustup +nightly component add miri rust-src >/dev/null 2>&1 || echo "nightly has no Miri" ;;
    registry) cargo info libm >/dev/null 2>&1 || echo "no registry reached" ;;
    valgrind) debian valgrind valgrind ;;
    parallel) debian parallel parallel ;;
    provers) debian sollya sollya && debian gappa gappa && python ;;
    qemu) debian qemu-system-arm qemu-system-arm; debian qemu-system-riscv32 qemu-system-misc ;;
    gcc) debian g++ g++; debian pkg-config pkg-config; debian arm-none-eabi-gcc gcc-arm-none-eabi; debian riscv64-unknown-elf-gcc gcc-riscv64-unknown-elf ;;
    s390x)
      debian qemu-s390x qemu-user && debian s390x-linux-gnu-gcc gcc-s390x-linux-gnu libc6-dev-s390x-cross &&
        target s390x-unknown-linux-gnu ;;
    aarch64)
      debian qemu-aarch64 qemu-user && debian aarch64-linux-gnu-gcc gcc-aarch64-linux-gnu libc6-dev-arm64-cross &&
        target aarch64-unknown-linux-gnu ;;
    defmt-print) installed "$1" "$1 --version" ;;
    cargo-fuzz) installed cargo-fuzz "cargo fuzz --version" ;;
    *) target "$1" ;;
  esac
}

debian() { # debian COMMAND PACKAGE…: one package a call, since a call fails as a whole
  command -v "$1" >/dev/null && return
  if [ "$(id -u)" = 0 ] && command -v apt-get >/dev/null; then
    local package
    for package in "${@:2}"; do
      apt-get install -y -qq "$package" || { apt-get update -qq && apt-get install -y -qq "$package"; }
    done >/dev/null 2>&1 </dev/null
  fi
  command -v "$1" >/dev/null || { echo "$1 is not installed (Debian: apt install ${*:2})"; return 1; }
}
python() { # with what the proofs import, in an environment of their own
  local venv=target/python
  { python3 -m venv "$venv" || { debian python3-venv python3-venv && python3 -m venv "$venv"; }; } >/dev/null 2>&1 &&
    "$venv/bin/python3" -m pip install --quiet python-flint mpmath >/dev/null 2>&1 ||
    echo "no Python with python-flint and mpmath (Debian: apt install python3-venv)"
}
component() { # absent from minimal installations
  cargo "${1/format/fmt}" --version >/dev/null 2>&1 || rustup component add "$1" >/dev/null 2>&1 ||
    echo "rustup cannot add $1"
}
target() {
  [ -d "$(rustc --print target-libdir --target "$1" 2>/dev/null)" ] || rustup target add "$1" >/dev/null 2>&1 ||
    { echo "rustup cannot add the target $1"; return 1; }
}
toolchain() {
  cargo "+$1" --version >/dev/null 2>&1 || rustup toolchain install "$1" --profile minimal >/dev/null 2>&1 ||
    { echo "rustup cannot install Rust $1"; return 1; }
}
installed() { # installed PACKAGE COMMAND
  $2 >/dev/null 2>&1 || cargo install "$1" --locked --quiet >/dev/null 2>&1 || echo "cargo install $1 failed"
}
# msrv [FEATURE]: the oldest Rust of the library, or of it with the feature: what its line in Cargo.toml says.
msrv() {
  local own
  own=$([ $# = 0 ] || sed -n "s/^$1 = .*# Rust \([0-9.]*\).*/\1/p" Cargo.toml)
  [ -n "$own" ] && echo "$own" || sed -n 's/^rust-version = "\(.*\)"/\1/p' Cargo.toml
}
msrvs() { sed -n -e 's/^rust-version = "\(.*\)"/\1/p' -e 's/^[a-z_]* = .*# Rust \([0-9.]*\).*/\1/p' Cargo.toml | sort -Vu; }

# Each in turn, while steps run that need none of them; what has to be compiled, beside the downloads.
install_in_background() { # install_in_background NEED…
  local compiled=() fetched=() need
  for need; do
    case $need in defmt-print | cargo-fuzz) compiled+=("$need") ;; *) fetched+=("$need") ;; esac
  done
  obtain_all "${fetched[@]}" &
  installers+=($!)
  obtain_all "${compiled[@]}" &
  installers+=($!)
}
obtain_all() {
  local need
  for need; do
    obtain "$need" >"$logs/$need.new"
    mv "$logs/$need.new" "$logs/$need.need" # in one, so that no step reads half of it
  done
}
