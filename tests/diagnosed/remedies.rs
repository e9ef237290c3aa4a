//! What has another way to be written.
#![no_std]
use bessemer::prelude::*;

/// Two rows.
#[function]
pub fn all(rows: &[[f64; 2]; 2]) -> f64 {
    rows.iter().flatten().sum::<f64>()
}
