//! `for` iterates over the elements of arrays, by reference or by value.

use bessemer::prelude::*;

/// The largest of the values.
#[function]
pub fn largest(values: &[f32; 6]) -> f32 {
    let mut most = values[0];
    for value in values {
        most = most.max(*value);
    }
    most
}

/// Exclusive or of all bytes.
#[function]
pub fn checksum(bytes: [u8; 7]) -> u8 {
    let mut sum = 0;
    for byte in bytes {
        sum ^= byte;
    }
    sum
}
