//! Iterator chains that end in a value become loops. The sum of floats begins with −0, as Rust's does.

use bessemer::prelude::*;

/// The mean of the squares.
#[function]
pub fn power(samples: &[f64; 8]) -> f64 {
    let sum: f64 = samples.iter().map(|x| x * x).sum();
    sum / 8.0
}

/// The sum of products, limited to `most`.
#[function]
pub fn weighted(values: &[i32; 4], weights: &[i32; 4], most: i32) -> i32 {
    values.iter().zip(weights).map(|(v, w)| v * w).filter(|p| *p <= most).sum()
}

/// Returns true if the values rise.
#[function]
pub fn rises(values: &[f32; 5]) -> bool {
    (1..5).all(|i| values[i] > values[i - 1])
}

/// Packs bits into a number.
#[function]
pub fn packed(flags: [bool; 8]) -> u8 {
    flags.iter().enumerate().fold(0, |bits, (i, &flag)| if flag { bits | 1 << i } else { bits })
}

/// n!
#[function]
pub fn factorial(n: u64) -> u64 {
    (1..=n.min(25)).product()
}
