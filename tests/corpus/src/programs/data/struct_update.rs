//! `..base` takes the remaining fields from another value.

use bessemer::prelude::*;

/// A command to a motor.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drive {
    pub speed: f32,
    pub torque: f32,
    pub brake: bool,
}

/// The command with the brake on.
#[function]
pub fn braked(drive: &Drive) -> Drive {
    Drive { speed: 0.0, brake: true, ..*drive }
}
