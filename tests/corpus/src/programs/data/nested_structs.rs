//! Structs contain other structs by value.

use bessemer::prelude::*;

/// A range of values.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Span {
    pub low: f32,
    pub high: f32,
}

/// Limits of a servo.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Servo {
    pub angle: Span,
    pub rate: Span,
}

/// The servo's limits, each widened by the corresponding part of `margin`.
#[function]
pub fn widened(servo: &Servo, margin: &Span) -> Servo {
    let mut wide = *servo;
    wide.angle.low -= margin.low;
    wide.angle.high += margin.high;
    wide.rate = Span { low: servo.rate.low * 2.0, high: servo.rate.high * 2.0 };
    wide
}
