#!/usr/bin/env bash
# nalgebra 0.35.0: `try_inverse` of 10¹⁰ times the identity of four rows is `Some` zero in `f32`; of five rows it is right.
#
# Guessed: the inverse of a matrix whose condition is 1 is right as long as its elements and their reciprocals are numbers.
# Seen:    up to four rows it divides cofactors by the determinant, the product of four elements. It overflows from 10¹⁰ on and the
#          inverse is zero, then NaN; it is subnormal at 10⁻¹¹ and the inverse infinite; it is zero at 10⁻¹² and the inverse `None`.
#          Five rows, and `lu().try_inverse()`, are right for each.
# So:      scale covariances of small numbers in `f32`, or invert by a decomposition. `Some` does not say that the inverse is one.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat > Cargo.toml <<'TOML'
[package]
name = "scales"
version = "0.0.0"
edition = "2024"

[dependencies]
nalgebra = { version = "=0.35.0", default-features = false, features = ["libm"] }
TOML
cat > src/main.rs <<'RUST'
use nalgebra::{Matrix4, Matrix5};

fn main() {
    for scale in [1e-12f32, 1e-11, 1e-3, 1e10, 1e13] {
        let first = |inverse: Option<Matrix4<f32>>| inverse.map(|it| format!("{:e}", it[(0, 0)]));
        let four = Matrix4::from_diagonal_element(scale);
        let five = Matrix5::from_diagonal_element(scale).try_inverse();
        let five = five.map(|it| format!("{:e}", it[(0, 0)]));
        println!("{scale:e}: {:?}; by LU {:?}; five rows {five:?}", first(four.try_inverse()), first(four.lu().try_inverse()));
    }
}
RUST
{ grep 'nalgebra =' Cargo.toml; cargo run --quiet; } | tee printed
grep -qx '1e-12: None; by LU Some("1e12"); five rows Some("1e12")' printed
grep -qx '1e-11: Some("inf"); by LU Some("1e11"); five rows Some("1e11")' printed
grep -q '^1e-3: Some("1e3"); by LU Some("9.9999[0-9]*e2"); five rows' printed
grep -qx '1e10: Some("0e0"); by LU Some("1e-10"); five rows Some("1e-10")' printed
grep -q '^1e13: Some("NaN"); by LU Some("1.0000000[0-9]*e-13"); five rows' printed
