//! Integers of 128 bits: structs of two words in the C.

use bessemer::prelude::*;

/// The upper word of the product of two words.
#[function]
pub fn upper(a: u64, b: u64) -> u64 {
    ((a as u128 * b as u128) >> 64) as u64
}

/// Converts ticks of a clock to nanoseconds; a fault for a frequency of 0.
#[function]
pub fn nanoseconds(ticks: u64, frequency: u32) -> u64 {
    (u128::from(ticks) * 1_000_000_000 / u128::from(frequency)) as u64
}

/// The mean of two words, rounded down, and the product of two halves.
#[function]
pub fn small(a: u64, b: u64, c: u32, d: u16) -> (u64, u64) {
    let mean = (a as u128 + b as u128) / 2;
    (mean as u64, (c as u128 * u128::from(d)) as u64)
}

/// The sum of squares.
#[function]
pub fn energy(samples: &[i32; 4]) -> u128 {
    let mut sum = 0;
    for &sample in samples {
        let magnitude = u128::from(sample.unsigned_abs());
        sum += magnitude * magnitude;
    }
    sum
}

/// Arithmetic with overflow, division by zero and shifts as faults.
#[function]
pub fn arithmetic(a: u128, b: u128, bits: u8) -> u128 {
    let sum = a * 3 + b;
    let rest = sum % (b | 1) - (sum / 7 >> 1);
    rest << bits
}

/// Operators on bits.
#[function]
pub fn masked(a: u128, b: u128) -> u128 {
    const LOW: u128 = 0xFFFF_FFFF_FFFF_FFFF_FFFF;
    (!a & LOW) ^ (b | 1 << 100) ^ 5_u128
}

/// Comparisons with numbers and with each other.
#[function]
pub fn class(a: u128, b: u128) -> u32 {
    if a == b || a == u128::MAX {
        0
    } else if a < 1_000_000_000_000_000_000_000 && a.min(b) != 0 {
        1
    } else if a >= b {
        2
    } else {
        3
    }
}

/// The product of two fixed-point numbers of 31 fractional bits, rounded to the nearest.
#[function]
pub fn scaled(a: i64, b: i64) -> i64 {
    ((a as i128 * b as i128 + (1 << 30)) >> 31) as i64
}
