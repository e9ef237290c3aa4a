//! Loops over windows and chunks of an array, with skipped and limited elements.

use bessemer::prelude::*;

/// The steepest step between neighbours.
#[function]
pub fn steepest(values: &[f64; 8]) -> f64 {
    let mut steepest: f64 = 0.0;
    for pair in values.windows(2) {
        steepest = steepest.max((pair[1] - pair[0]).abs());
    }
    steepest
}

/// Sums of groups of three samples.
#[function]
pub fn sums(samples: &[u16; 9]) -> [u32; 3] {
    let mut sums = [0; 3];
    for (sum, chunk) in sums.iter_mut().zip(samples.chunks_exact(3)) {
        *sum = chunk.iter().map(|sample| *sample as u32).sum();
    }
    sums
}

/// The mean without the first two values.
#[function]
pub fn settled(values: &[f32; 10]) -> f32 {
    values.iter().skip(2).sum::<f32>() / 8.0
}

/// Number of flags set among the last four.
#[function]
pub fn recent(flags: &[bool; 12]) -> usize {
    flags.iter().rev().take(4).filter(|flag| **flag).count()
}
