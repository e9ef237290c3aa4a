//! Ranges that include their end, and reversed ones.

use bessemer::prelude::*;

/// A polynomial by Horner's rule, highest power first.
#[function]
pub fn polynomial(coefficients: &[f64; 5], x: f64) -> f64 {
    let mut value = 0.0;
    for i in (0..5).rev() {
        value = value * x + coefficients[i];
    }
    value
}

/// The sum of 1 … n.
#[function]
pub fn triangle(n: u8) -> u32 {
    let mut sum = 0;
    for i in 1..=u32::from(n) {
        sum += i;
    }
    sum
}
