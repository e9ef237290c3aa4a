#!/usr/bin/env bash
# fixed 1.31.0 (the crate): `x * 0.5`, `x / 2` and the conversions of a fixed-point number round in three directions.
#
# Guessed: one rule of rounding holds for a type, as for floats, so half of a number is the same by product and by quotient.
# Seen:    of the smallest negative `I16F16`, the product by 0.5 is itself (down) and the quotient by 2 is zero (towards zero). 1.5 steps as
#          a float become 2 steps (nearest, ties to even), and -0.25 becomes -1 as an `i32` (down), which `as` of a float does not do.
# So:      an integrator that halves by products drifts downwards: add half a step before, or compare with the reference by bits.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
mkdir src
cat > Cargo.toml <<'TOML'
[package]
name = "steps"
version = "0.0.0"
edition = "2024"

[dependencies]
fixed = "=1.31.0"
TOML
cat > src/main.rs <<'RUST'
use fixed::types::I16F16;

fn main() {
    let step = I16F16::from_bits(-1);
    println!("-1 step: {} times 0.5, {} divided by 2", (step * I16F16::from_num(0.5)).to_bits(), (step / 2).to_bits());
    let steps = |float: f64| I16F16::from_num(float / 65536.0).to_bits();
    println!("from a float: 0.5 steps {}, 1.5 steps {}, -1.5 steps {}", steps(0.5), steps(1.5), steps(-1.5));
    let number = I16F16::from_num(-0.25);
    println!("-0.25 as an i32: {}, of a float: {}", number.to_num::<i32>(), -0.25_f64 as i32);
    let mut decay = I16F16::from_num(-1);
    for _ in 0..100 {
        decay *= I16F16::from_num(0.5);
    }
    println!("-1 halved 100 times by products: {} steps", decay.to_bits());
}
RUST
{ grep 'fixed =' Cargo.toml; cargo run --quiet; } | tee printed
grep -qx -- '-1 step: -1 times 0.5, 0 divided by 2' printed
grep -qx 'from a float: 0.5 steps 0, 1.5 steps 2, -1.5 steps -2' printed
grep -qx -- '-0.25 as an i32: -1, of a float: 0' printed
grep -qx -- '-1 halved 100 times by products: -1 steps' printed
