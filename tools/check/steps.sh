# The steps of ./check, longest first, and what they run. Sourced by ./check.
# Steps that hold the same lock run one after the other: they would wait for one build folder, or overwrite
# each other's images. A need is what tools/check/install.sh obtains; one with ? the step can do without.

boards=qemu?,gcc?,defmt-print?,thumbv6m-none-eabi?,thumbv7m-none-eabi?,thumbv7em-none-eabi?,thumbv7em-none-eabihf?,riscv32imc-unknown-none-elf?
#    name                     when  locks          needs             command
step format                   quick -              format            formats
step lockfiles                quick -              -                 lockfiles
step lints                    quick clippy         clippy            lints
step tests                    quick dev            -                 tests
step boards-links             full  boards         $boards           on_target links
step costs-host               full  release        valgrind?         costs_on_host
step vectors                  full  release        valgrind          cargo run --release --quiet -p accuracy_cost -- vectors
step boards-run               full  boards         $boards           on_target run
step proofs                   full  proofs         provers           target/python/bin/python3 proofs/run
step boards-cost              full  boards         $boards           on_target cost --check
step features                 full  dev            -                 features_alone
step big-endian-miri          full  miri           miri              big_endian_in_miri
step fuzz                     full  fuzz           nightly,cargo-fuzz fuzz
step boards-hashes            full  boards         $boards           on_target hashes
step proofs-planted           full  proofs         provers           target/python/bin/python3 proofs/run --planted
step release-bits             full  release        -                 cargo test --release --quiet -p shade --test shade golden
step boards-scenes            full  boards         $boards           on_target shade
step boards-c                 full  boards         $boards           on_target c
step boards-self-test         full  boards         $boards           on_target self-test
step boards-hashes-debug      full  boards         qemu,thumbv7em-none-eabihf on_target hashes --debug --only M4F --last 256
step boards-hashes-planted    full  boards         qemu,thumbv7em-none-eabihf planted_hash_is_caught
step lints-firmware           full  lints-firmware $boards,clippy    lints_of_firmware
step big-endian               full  s390x          s390x             big_endian_in_qemu
step aarch64                  full  aarch64        aarch64           aarch64_in_qemu
step unoptimised              full  unoptimised    -                 unoptimised
step figures                  quick -              -                 python3 tools/figures.py --check
step docs                     quick docs           -                 docs
step docs-rs                  full  docs-rs        nightly           docs_as_on_docs_rs
step msrv                     full  msrv           msrv              oldest_compilers
step targets                  full  targets        thumbv6m-none-eabi?,thumbv7em-none-eabihf? core_for_targets
step publish                  full  publish        registry          cargo publish --dry-run --allow-dirty --quiet
step readme                   full  release        -                 readme
step runner                   quick -              -                 runner_says_what_it_lacks
step parts                    full  release        parallel          tools/errors_in_parts_check
step template                 full  template       qemu,thumbv7em-none-eabihf tools/check/template
step refused-targets          full  -              i586-unknown-linux-gnu tools/refused_targets
step refused-programs         full  -              -                    tools/refused_programs
step readme-firmware          full  boards         qemu,defmt-print,thumbv7em-none-eabihf tools/check/readme README.md firmware

workspaces=(Cargo.toml fuzz/Cargo.toml examples/firmware/Cargo.toml)
formats() {
  local manifest
  for manifest in "${workspaces[@]}"; do cargo fmt --all --check --manifest-path "$manifest"; done
}
lockfiles() { # as committed, so that two machines build the same
  local manifest
  for manifest in "${workspaces[@]}"; do
    cargo metadata --locked --format-version 1 --manifest-path "$manifest" >/dev/null
  done
}
features() { awk '/^\[/ { on = /features/ } on && / = / { print $1 }' Cargo.toml; } # the library's
all_features() { features | sed 's|^|coslobe/|' | paste -sd ,; } # and not those that plant a fault
# With all features, and the library alone with none. (Tests see features of what they depend on.)
lints() {
  cargo clippy --workspace --all-targets --features "$(all_features)" --quiet -- -D warnings
  cargo clippy --lib --quiet -- -D warnings
}
tests() { cargo test --quiet --no-fail-fast --workspace --features "$(all_features)"; }
lints_of_firmware() { # one by one, since features of dependencies differ between them
  local target
  for target in $(there thumbv6m-none-eabi thumbv7m-none-eabi thumbv7em-none-eabihf riscv32imc-unknown-none-elf); do
    cargo clippy --quiet --manifest-path examples/firmware/Cargo.toml --workspace "$target" \
      --target-dir target/on_target/lints -- -D warnings
  done
}
there() { # there TARGET…: --target=… for those whose core is there
  local target
  for target; do
    [ -s "$logs/$target.need" ] && echo "SKIPPED: $target: $(<"$logs/$target.need")" >&2 || echo "--target=$target"
  done
}
docs() { RUSTDOCFLAGS="-D warnings" cargo doc --no-deps --all-features --quiet; }
docs_as_on_docs_rs() {
  RUSTDOCFLAGS="--cfg docsrs -D warnings" cargo +nightly doc --no-deps --all-features --quiet --target-dir target/docsrs
}
features_alone() { # the library by itself too: what the tests depend on switches features on
  local feature
  for feature in "" $(features); do
    echo "feature: ${feature:-none}"
    cargo check --quiet --lib --features "$feature"
    cargo test --quiet --features "$feature" --test integrations --test values
  done
}
oldest_compilers() { # each feature by the Rust that Cargo.toml says, and all that say none together
  local feature rust plain
  plain=$(features | while read -r feature; do [ "$(msrv "$feature")" != "$(msrv)" ] || echo "$feature"; done | paste -sd ,)
  cargo "+$(msrv)" build --lib --quiet --target-dir target/msrv
  cargo "+$(msrv)" check --lib --quiet --target-dir target/msrv --features "$plain"
  for feature in $(features); do
    rust=$(msrv "$feature")
    [ "$rust" = "$(msrv)" ] || cargo "+$rust" check --lib --quiet --target-dir target/msrv --features "$feature"
  done
}
core_for_targets() {
  local targets
  targets=$(there thumbv6m-none-eabi thumbv7em-none-eabihf)
  [ -n "$targets" ] || return 0
  cargo build --release --quiet --lib $targets
  cargo build --release --quiet --lib $targets --features defmt,heapless,fixed,mint,serde
  # Without atomics nothing emulates them, on no target that a firmware might have.
  if cargo tree --edges normal --features fixed,defmt,heapless,mint,serde,rand --target all |
    grep -E 'portable-atomic|critical-section'; then return 1; fi
}

costs_on_host() { # without valgrind it still asks each sampler for its law
  cargo run --release --quiet -p accuracy_cost -- --check
}
# Firmware on emulated boards; it counts itself what it must skip.
on_target() { # on_target SUBCOMMAND…
  cargo run --release --quiet -p on_target -- "$@"
}
planted_hash_is_caught() { # by law, type and input
  if on_target hashes --only M4F --planted >"$logs/planted" 2>&1; then return 1; fi
  grep 'found Ball f32 samples 777 cos' "$logs/planted"
}
hashes() { # hashes FOLDER "CARGO TEST" ARGUMENT…: what the boards compute, on another machine or in another way
  $2 --quiet -p kit --no-default-features --test hashes --target-dir "target/on_target/$1" "${@:3}"
}
unoptimised() { # with overflow checks
  COSLOBE_LAST=1024 CARGO_PROFILE_DEV_OPT_LEVEL=0 hashes host "cargo test"
}
big_endian_in_qemu() { # all types
  export CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_LINKER=s390x-linux-gnu-gcc
  export CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_RUNNER="qemu-s390x -L /usr/s390x-linux-gnu"
  COSLOBE_LAST=16384 hashes s390x "cargo test" --release --target s390x-unknown-linux-gnu -- --skip precise_f32
  # Unoptimised: from opt-level 1 on Rust 1.95 compiles a density of this type for s390x to 1/128 of its value.
  COSLOBE_LAST=1024 CARGO_PROFILE_RELEASE_OPT_LEVEL=0 hashes s390x-unoptimised "cargo test" --release \
    --target s390x-unknown-linux-gnu -- --exact precise_f32_hashes
}
aarch64_in_qemu() { # NEON: all types, and slices beside scalar calls
  export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc
  export CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER="qemu-aarch64 -L /usr/aarch64-linux-gnu"
  COSLOBE_LAST=16384 hashes aarch64 "cargo test" --release --target aarch64-unknown-linux-gnu
  cargo test --quiet --release --features simd --test batches --target aarch64-unknown-linux-gnu \
    --target-dir target/on_target/aarch64
}
big_endian_in_miri() { # what it adds to QEMU: undefined behaviour in what the crate depends on
  COSLOBE_LAST=64 hashes miri "cargo +nightly miri test" --target s390x-unknown-linux-gnu -- --exact \
    f32_hashes fast_f32_hashes f64_hashes fixed_hashes fixed16_hashes
}

fuzz() { # each target for FUZZ_SECONDS
  local file name length
  # No sanitizer: no code here is unsafe.
  cargo +nightly fuzz build -s none
  for file in fuzz/fuzz_targets/*.rs; do
    name=$(basename "$file" .rs)
    # A scratch corpus first, so that what a run finds does not land among the committed seeds.
    mkdir -p "fuzz/corpus/$name"
    length=64 # four bytes that choose, and eight words; of a scene, text
    if [ "$name" = scene ]; then length=4096; else fuzz/seeds.py unpack "$name"; fi
    cargo +nightly fuzz run -s none "$name" "fuzz/corpus/$name" $(ls -d "fuzz/seeds/$name" 2>/dev/null) -- \
      -max_len=$length -max_total_time="${FUZZ_SECONDS:-20}" -verbosity=0
  done
}
readme() { # its snippets in a package of a user's, and its commands
  tools/check/readme_test
  tools/check/readme README.md
}
runner_says_what_it_lacks() { # in one line, where `cargo run` in examples/firmware cannot show anything
  local bin=$PWD/$logs/bin said
  mkdir -p "$bin"
  ln -sf $(command -v bash grep sed basename) "$bin"
  echo _defmt_version_ >"$logs/image"
  if said=$(PATH=$bin examples/firmware/run mps2-an386 "$logs/image" 2>&1); then return 1; fi
  echo "$said"
  [ "$said" = "run: not installed: qemu-system-arm (Debian: apt install qemu-system-arm), \
defmt-print (cargo install defmt-print --locked)" ]
}
