//! `min`, `max` and `clamp` are the same on every target: −0 is below +0, and a NaN gives the other operand.

use bessemer::prelude::*;

/// The smaller of two numbers, and at least 0.
#[function]
pub fn allowed(wanted: f64, limit: f64) -> f64 {
    wanted.min(limit).max(0.0)
}

/// A command limited to the motor's range.
#[function]
pub fn throttle(command: f32) -> f32 {
    command.clamp(0.0, 1.0)
}

/// A sum limited to the range of a byte.
#[function]
pub fn sum(a: u8, b: u8) -> u8 {
    (u16::from(a) + u16::from(b)).min(u16::from(u8::MAX)) as u8
}
