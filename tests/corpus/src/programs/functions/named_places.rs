//! A named reference to a part of a value is the part itself in the C. Its index is computed and checked once, at the
//! `let`.

use bessemer::prelude::*;

/// A motor.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Motor {
    pub speed: f32,
    pub on: bool,
}

/// Sets the speed of a motor; returns whether it runs now.
#[function]
pub fn drive(motors: &mut [Motor; 4], which: usize, speed: f32) -> bool {
    let motor = &mut motors[which];
    motor.speed = speed;
    motor.on = speed != 0.0;
    motor.on
}

