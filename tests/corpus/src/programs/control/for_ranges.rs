//! `for` iterates over ranges; a range with constant bounds has a `uint32_t` counter and no check.

use bessemer::prelude::*;

/// The sum of a window, and the number of its negative values.
#[function]
pub fn window(values: &[i16; 8]) -> [i32; 2] {
    let mut sum = 0;
    let mut negative = 0;
    for i in 0..8 {
        sum += i32::from(values[i]);
        if values[i] < 0 {
            negative += 1;
        }
    }
    [sum, negative]
}

/// Falling factorial, modulo 2^32.
#[function]
pub fn falling(n: u32, k: u8) -> u32 {
    let mut product: u32 = 1;
    for i in 0..u32::from(k) {
        product = product.wrapping_mul(n.wrapping_sub(i));
    }
    product
}
