#!/usr/bin/env bash
# nalgebra 0.35.0: `Rotation3` of a half turn has no axis, `scaled_axis` zero and a root of NaN; small turns in `f32` have angle zero.
#
# Guessed: a `Rotation3` and the `UnitQuaternion` of the same rotation have the same axis, angle and powers, up to rounding.
# Seen:    the matrix's axis is its antisymmetric part, which is zero for diag(-1, -1, 1), and its angle comes from the trace, which is 3
#          for every turn below 0.0004 rad in `f32`: such a rotation counts as the identity. The quaternion has each.
# So:      convert to a `UnitQuaternion` before asking for an axis, an angle, a power or an interpolation.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat > Cargo.toml <<'TOML'
[package]
name = "turns"
version = "0.0.0"
edition = "2024"

[dependencies]
nalgebra = { version = "=0.35.0", default-features = false, features = ["libm"] }
TOML
cat > src/main.rs <<'RUST'
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

fn main() {
    let half = Rotation3::from_matrix_unchecked(Matrix3::from_diagonal(&Vector3::new(-1.0f64, -1.0, 1.0)));
    let quaternion = UnitQuaternion::from_rotation_matrix(&half);
    println!("half turn, axis: {} and {}", half.axis().is_some(), quaternion.axis().is_some());
    println!("half turn, scaled_axis().z: {} and {}", half.scaled_axis().z, quaternion.scaled_axis().z);
    println!("half turn, powf(0.5).angle(): {} and {}", half.powf(0.5).angle(), quaternion.powf(0.5).angle());
    let small = Rotation3::from_scaled_axis(Vector3::new(0.0f32, 3e-4, 0.0));
    let quaternion = UnitQuaternion::from_rotation_matrix(&small);
    println!("turn of 0.0003, angle(): {} and {}", small.angle(), quaternion.angle());
    println!("turn of 0.0003, scaled_axis().y: {} and {}", small.scaled_axis().y, quaternion.scaled_axis().y);
}
RUST
{ grep 'nalgebra =' Cargo.toml; echo 'Rotation3 and UnitQuaternion:'; cargo run --quiet; } | tee printed
grep -qx 'half turn, axis: false and true' printed
grep -qx 'half turn, scaled_axis().z: 0 and 3.14159[0-9]*' printed
grep -qx 'half turn, powf(0.5).angle(): NaN and 1.57079[0-9]*' printed
grep -qx 'turn of 0.0003, angle(): 0 and 0.000[23][0-9]*' printed
grep -qx 'turn of 0.0003, scaled_axis().y: 0 and 0.000[23][0-9]*' printed
