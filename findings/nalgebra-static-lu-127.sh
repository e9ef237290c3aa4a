#!/usr/bin/env bash
# nalgebra 0.35.0: `SMatrix<f64, N, N>::lu()` compiles up to N = 127 and for no larger N.
#
# Guessed: a decomposition of a matrix of static size exists for each size, as its product and its transpose do.
# Seen:    `SMatrix<f64, 127, 127>` has `lu()`; for 128 rustc says that `Const<128>: ToTypenum` does not hold.
# So:      larger systems of static size need a decomposition of one's own, or nalgebra's matrices of dynamic size.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat >Cargo.toml <<'TOML'
[package]
name = "sizes"
version = "0.0.0"
edition = "2024"

[dependencies]
nalgebra = { version = "=0.35.0", default-features = false, features = ["libm"] }
TOML
check() {
    cat >src/lib.rs <<RUST
pub fn determinant(a: nalgebra::SMatrix<f64, $1, $1>) -> f64 { a.lu().determinant() }
pub fn product(a: nalgebra::SMatrix<f64, $1, $1>) -> nalgebra::SMatrix<f64, $1, $1> { a * a }
RUST
    cargo check --quiet 2>errors && echo "$1: compiles" || echo "$1: $(grep -m 1 'ToTypenum' errors)"
}
{ grep 'nalgebra =' Cargo.toml; check 127; check 128; } | tee printed
grep -q '127: compiles' printed
grep -q '128: .*ToTypenum' printed
