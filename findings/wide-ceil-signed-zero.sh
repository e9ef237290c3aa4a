#!/usr/bin/env bash
# wide 1.7.1 without `std`: the sign of a rounded zero depends on the instruction set that the program is compiled for.
#
# Guessed: `f64x8::ceil` is IEEE 754's, as `f64::ceil` is: -0.5 is rounded up to -0.0, whatever the processor.
# Seen:    without the feature `std`, compiled for x86-64 without SSE 4.1, the default target, ceil(-0.5) is +0.0, while trunc(-0.5) is
#          -0.0; with SSE 4.1 or AVX both are -0.0. So the same source has other bits after `-C target-cpu=native`, and a quotient by the result has the other infinity.
# So:      give the result the sign of the argument, which is right for every number.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat > Cargo.toml <<'TOML'
[package]
name = "rounded"
version = "0.0.0"
edition = "2021"

[dependencies]
wide = { version = "=1.7.1", default-features = false }
TOML
cat > src/main.rs <<'RUST'
fn main() {
    let x = wide::f64x8::new([std::hint::black_box(-0.5); 8]);
    let first = |value: wide::f64x8| value.to_array()[0];
    println!("wide: ceil {:?} trunc {:?}; std: ceil {:?}", first(x.ceil()), first(x.trunc()), std::hint::black_box(-0.5_f64).ceil());
}
RUST
{
    cargo fetch --quiet
    echo "wide $(sed -n '/name = "wide"/{n;s/.*"\(.*\)"/\1/p}' Cargo.lock)"
    RUSTFLAGS= cargo run --quiet --target-dir plain
    RUSTFLAGS='-C target-feature=+sse4.1' cargo run --quiet --target-dir sse4
} | tee printed
[ "$(sed -n 2p printed)" = 'wide: ceil 0.0 trunc -0.0; std: ceil -0.0' ]
[ "$(sed -n 3p printed)" = 'wide: ceil -0.0 trunc -0.0; std: ceil -0.0' ]
