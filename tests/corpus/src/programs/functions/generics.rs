//! A function may be generic over types and sizes. The C has
//! one function for each instance, named after its arguments.

use bessemer::prelude::*;

/// The mean of some values; 0 if there are none.
#[function]
fn mean<T: Real, const N: usize>(values: &[T; N]) -> T {
    let mut sum = T::ZERO;
    for value in values {
        sum += *value;
    }
    if N == 0 { T::ZERO } else { sum / real(N as f64) }
}

/// The larger of two values.
#[function]
fn larger<T: PartialOrd + Copy>(a: T, b: T) -> T {
    if b > a { b } else { a }
}

/// The larger of two means, of measurements in different precision.
#[function]
pub fn level(coarse: &[f32; 3], fine: &[f64; 4], least: i32) -> f64 {
    let least = larger(least, -100);
    larger(larger(mean(coarse).as_f64(), mean(fine)), least as f64)
}
