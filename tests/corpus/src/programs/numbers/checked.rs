//! Integer arithmetic is checked: where Rust panics, the C returns a fault. Arithmetic that cannot overflow has no
//! check.

use bessemer::prelude::*;

/// The mean of two counts; the sum of two `u16` may overflow.
#[function]
pub fn mean(a: u16, b: u16) -> u16 {
    (a + b) / 2
}

/// The mean in a wider type, which needs no check.
#[function]
pub fn mean_of_wide(a: u16, b: u16) -> u16 {
    ((a as u32 + b as u32) / 2) as u16
}
