//! Two more ways to consume a chain: `for_each`, which is a loop, and `reduce`, which begins with the first item.

use bessemer::prelude::*;
use core::cmp;

/// Halves all samples, in place.
#[function]
pub fn halve(samples: &mut [f64; 5]) {
    samples.iter_mut().for_each(|sample| *sample *= 0.5);
}

/// The sum of every second sample, weighted by its index.
#[function]
pub fn moment(samples: &[f64; 5]) -> f64 {
    let mut sum = 0.0;
    samples.iter().enumerate().filter(|(place, _)| place % 2 == 0).for_each(
        |(place, sample): (usize, &f64)| {
            let weight = place as f64;
            sum += weight * sample;
        },
    );
    sum
}

/// Adds numbers to sums, as far as both arrays go.
#[function]
pub fn added(sums: &mut [u16; 4], parts: &[u8; 3]) {
    sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += u16::from(*part));
}

/// The largest of some numbers; a NaN is ignored.
#[function]
pub fn largest(values: &[f64; 4], count: usize) -> Option<f64> {
    values.iter().copied().take(count).reduce(f64::max)
}

/// The difference of all values in order; an overflow faults at its iteration.
#[function]
pub fn balance(values: &[i32; 5]) -> i32 {
    values.iter().map(|x| x / 2).reduce(|so_far, x| if so_far > x { so_far - x } else { so_far + x }).unwrap_or(0)
}

/// Folds of a range and of filtered items.
#[function]
pub fn parity(end: u8) -> Option<u8> {
    (0..end).filter(|x| x % 3 == 1).reduce(|a, b| a ^ b)
}

/// Limits a value with Rust's functions.
#[function]
pub fn within(value: i32, low: i32, high: u8) -> i32 {
    cmp::max(low, core::cmp::min(value, i32::from(high)))
}

/// A literal has the type of the other operand.
#[function]
pub fn positive(value: i16) -> i16 {
    let mut least = 0;
    least = cmp::max(least, value);
    cmp::min(1000, least)
}
