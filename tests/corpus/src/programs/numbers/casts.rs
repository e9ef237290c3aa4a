//! `as` works as in Rust: floats are truncated and saturate, NaN becomes 0, integers wrap. Mixed types without `as`
//! are an error of rustc.

use bessemer::prelude::*;

/// A duty cycle as the count of a timer with 10 bits.
#[function]
pub fn counts(duty: f64) -> u16 {
    (duty * 1023.0) as u16
}

/// The low byte, interpreted as a signed number.
#[function]
pub fn low_byte(word: u32) -> i8 {
    word as i8
}

/// Converts an integer to a float and back.
#[function]
pub fn through_float(n: i64) -> i64 {
    n as f32 as i64
}
