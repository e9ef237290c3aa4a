//! An assignment to several places evaluates every value before it writes the first.

use bessemer::prelude::*;

/// The Fibonacci number of an index, modulo 2^32.
#[function]
pub fn fibonacci(n: u8) -> u32 {
    let (mut a, mut b) = (0_u32, 1_u32);
    for _ in 0..n {
        (a, b) = (b, a.wrapping_add(b));
    }
    a
}

/// Two numbers in order.
#[function]
pub fn ordered(mut low: f64, mut high: f64) -> (f64, f64) {
    if low > high {
        (low, high) = (high, low);
    }
    (low, high)
}
