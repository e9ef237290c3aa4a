//! A `while` that counts needs no declared bound: the compared variable moves in one direction in every iteration.

use bessemer::prelude::*;

/// Number of samples at the start that are below the limit.
#[function]
pub fn quiet(samples: &[f32; 16], limit: f32) -> usize {
    let mut count = 0;
    while count < samples.len() && samples[count] < limit {
        count += 1;
    }
    count
}

/// Index at which `x` could be inserted into an ascending table (bisection).
#[function]
pub fn place(table: &[f32; 16], x: f32) -> usize {
    let (mut low, mut high) = (0, 16);
    while low < high {
        let middle = (low + high) / 2;
        if table[middle] <= x {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    low
}

/// The greatest common divisor (Euclid).
#[function]
pub fn divisor(a: u32, b: u32) -> u32 {
    let (mut a, mut b) = (a, b);
    while b != 0 {
        let rest = a % b;
        a = b;
        b = rest;
    }
    a
}
