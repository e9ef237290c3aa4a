//! `pow` of integers is checked; squares and cubes are products.

use bessemer::prelude::*;

/// The volume of a cube.
#[function]
pub fn volume(edge: u16) -> u64 {
    u64::from(edge).pow(3)
}

/// A power of ten.
#[function]
pub fn scale(digits: u32) -> u32 {
    10_u32.pow(digits)
}
