//! `wrapping_…` counts modulo two to the number of bits.

use bessemer::prelude::*;

/// The next of a series of numbers that look random (Numerical Recipes' constants).
#[function]
pub fn next(seed: u32) -> u32 {
    seed.wrapping_mul(1664525).wrapping_add(1013904223)
}

/// Number of elapsed ticks, also across the counter's overflow.
#[function]
pub fn elapsed(now: u32, then: u32) -> i32 {
    now.wrapping_sub(then) as i32
}
