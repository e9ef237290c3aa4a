//! A block is a value and may declare variables of its own.

use bessemer::prelude::*;

/// The area of a triangle by Heron's formula.
#[function]
pub fn area(a: f64, b: f64, c: f64) -> f64 {
    let half = (a + b + c) / 2.0;
    let square = {
        let (x, y, z) = (half - a, half - b, half - c);
        half * x * y * z
    };
    if square > 0.0 { square.sqrt() } else { 0.0 }
}
