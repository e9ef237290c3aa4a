//! A chain may end in an `Option`: the minimum, the maximum, the first match, or its index.

use bessemer::prelude::*;

/// The largest of some counts.
#[function]
pub fn largest(counts: &[i32; 6]) -> Option<i32> {
    counts.iter().copied().filter(|count| *count > 0).max()
}

/// Index of the first channel over its limit.
#[function]
pub fn over(channels: &[f64; 5], limits: &[f64; 5]) -> Option<usize> {
    channels.iter().zip(limits).position(|(channel, limit)| channel > limit)
}

/// The first empty cell.
#[function]
pub fn empty(cells: &[f32; 8]) -> Option<f32> {
    cells.iter().copied().find(|voltage| *voltage < 3.0)
}

/// The sum of the values that are finite, at most `most`.
#[function]
pub fn finite(values: &[f64; 4], most: f64) -> f64 {
    let mut sum = 0.0;
    for value in values.iter().copied().filter(|value| value.is_finite()) {
        sum += value;
        if sum > most {
            break;
        }
    }
    sum
}

/// The largest magnitude.
#[function]
pub fn peak(values: &[f64; 8]) -> f64 {
    values.iter().copied().map(f64::abs).fold(0.0, f64::max)
}
