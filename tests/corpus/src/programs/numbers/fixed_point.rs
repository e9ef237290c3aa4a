//! Fixed-point arithmetic: a wider product, and a shift.

use bessemer::prelude::*;

/// The product of two numbers with 15 fractional bits, rounded.
#[function]
pub fn product(a: i16, b: i16) -> i16 {
    let wide = (i32::from(a) * i32::from(b) + (1 << 14)) >> 15;
    wide.clamp(-32768, 32767) as i16
}
