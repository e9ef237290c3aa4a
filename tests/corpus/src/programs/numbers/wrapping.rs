//! `wrapping_…` computes modulo two to the power of the type's width.

use bessemer::prelude::*;

/// The next pseudo-random number (the constants are from Numerical Recipes).
#[function]
pub fn next(seed: u32) -> u32 {
    seed.wrapping_mul(1664525).wrapping_add(1013904223)
}

/// Number of elapsed ticks, also across the counter's overflow.
#[function]
pub fn elapsed(now: u32, then: u32) -> i32 {
    now.wrapping_sub(then) as i32
}
