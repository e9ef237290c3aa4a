//! `step_by` takes every n-th number of a range.

use bessemer::prelude::*;

/// The sum of the even elements, and of the odd ones from behind, each less than the one before.
#[function]
pub fn interleaved(values: &[f64; 10]) -> f64 {
    let mut sum = 0.0;
    for i in (0..10).step_by(2) {
        sum += values[i];
    }
    for i in (1..10).step_by(2).rev() {
        sum = 0.5 * sum + values[i];
    }
    sum
}

/// Every third number from `from` to below `to`.
#[function]
pub fn thirds(from: u8, to: u8) -> u32 {
    let mut sum = 0;
    for n in (from..to).step_by(3) {
        sum += n as u32;
    }
    sum
}
