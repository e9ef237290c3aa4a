//! `min`, `max` and `clamp` have one meaning on every target: −0 is below +0, a NaN gives the other operand.

use bessemer::prelude::*;

/// The smaller of two, and at least 0.
#[function]
pub fn allowed(wanted: f64, limit: f64) -> f64 {
    wanted.min(limit).max(0.0)
}

/// A command within what the motor can do.
#[function]
pub fn throttle(command: f32) -> f32 {
    command.clamp(0.0, 1.0)
}

/// A sum that stays in a byte.
#[function]
pub fn sum(a: u8, b: u8) -> u8 {
    (u16::from(a) + u16::from(b)).min(u16::from(u8::MAX)) as u8
}
