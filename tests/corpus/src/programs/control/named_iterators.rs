//! Iterators and ranges with a name, consumed later.

use bessemer::prelude::*;

/// A named chain that is consumed after other statements.
#[function]
pub fn spread(samples: &[f64; 8]) -> f64 {
    let mean = samples.iter().sum::<f64>() / 8.0;
    let squares = samples.iter().map(|x| (x - mean) * (x - mean));
    let count = 7.0;
    squares.sum::<f64>() / count
}

/// A chain that is consumed twice.
#[function]
pub fn twice(samples: &[i32; 5], least: i32) -> (u32, i32) {
    let above = samples.iter().filter(|x| **x > least);
    let count = above.clone().count() as u32;
    (count, above.fold(0, |sum, x| sum.wrapping_add(*x)))
}

/// Named iterators in a `for`, zipped, and a named range.
#[function]
pub fn weighted(samples: &[u16; 6], weights: &[u16; 6]) -> u32 {
    let middle = 1..5;
    let pairs = samples.iter().zip(weights);
    let mut sum = 0;
    for (x, w) in pairs {
        sum += u32::from(*x) * u32::from(*w) / 4096;
    }
    for i in middle {
        sum += u32::from(samples[i]);
    }
    sum
}

/// Values computed at compile time, and `match` on floats.
#[function]
pub fn shape(x: f64, up: bool) -> f64 {
    const { assert!(1 < 2) };
    match (x, up) {
        (0.0, _) => 1.0,
        (1.0..=2.0, true) => 2.0 * x,
        (x, false) if x < 0.0 => const { 3.0 },
        _ => match x {
            4.0 | 5.0 => 0.5,
            ..1.0 => -1.0,
            _ => libm::fabs(x),
        },
    }
}

/// Magnitudes, including the lowest numbers of the types, which have no negative.
#[function]
pub fn magnitudes(x: i8, y: i64) -> (i8, i64) {
    (x.saturating_neg(), y.saturating_abs())
}
