#!/usr/bin/env bash
# libm 0.2.16: its square root stays an instruction of SSE where the program is compiled for AVX.
#
# Guessed: `libm::sqrt` is what the compiler makes of a square root for the target: `vsqrtsd` after `-C target-cpu=x86-64-v3`, as of `f64::sqrt`.
# Seen:    on x86-64 it is inline assembly, `sqrtsd`, for every target. Amid instructions of AVX the legacy encoding keeps the upper half of a register,
#          so it waits for that register's last value, and on some processors for a change of state as well. A filter with a few roots in each step can be several
#          times slower when it is compiled for the newer processor. nalgebra with the feature `libm` takes its roots from here.
# So:      in programs of this kind use `f64::sqrt` of the standard library, or compile for SSE.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
[ "$(uname -m)" = x86_64 ] || { echo "this is about x86-64"; exit 0; }
mkdir src
cat > Cargo.toml <<'TOML'
[package]
name = "roots"
version = "0.0.0"
edition = "2021"

[lib]
crate-type = ["rlib"]

[dependencies]
libm = { version = "=0.2.16", default-features = false, features = ["arch"] }

[profile.release]
codegen-units = 1
lto = "fat"
TOML
cat > src/lib.rs <<'RUST'
#[no_mangle]
pub fn of_libm(x: f64) -> f64 {
    libm::sqrt(x)
}

#[no_mangle]
pub fn of_std(x: f64) -> f64 {
    x.sqrt()
}
RUST
cat > src/main.rs <<'RUST'
fn main() {
    let x: f64 = std::env::args().count() as f64;
    println!("{} {}", roots::of_libm(x), roots::of_std(x));
}
RUST
RUSTFLAGS='-C target-cpu=x86-64-v3' cargo rustc --quiet --release --bin roots -- --emit asm -C save-temps=no > /dev/null
{
    echo "libm $(sed -n '/name = "libm"/{n;s/.*"\(.*\)"/\1/p}' Cargo.lock)"
    of() { sed -n "/^$1:/,/cfi_endproc/p" target/release/deps/roots-*.s | grep -oE '\bv?sqrtsd\b' | sort -u | tr '\n' ' '; }
    echo "of_libm: $(of of_libm)"
    echo "of_std: $(of of_std)"
} | tee printed
grep -qxF 'of_libm: sqrtsd ' printed
grep -qxF 'of_std: vsqrtsd ' printed
