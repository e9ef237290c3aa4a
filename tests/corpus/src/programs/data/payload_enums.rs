//! An enum with payload is a tag and a union; only the member of the tag is ever read.

use bessemer::prelude::*;

/// Commands of a motor.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Command {
    /// No drive.
    #[default]
    Coast,
    /// Drive at a speed, rad/s.
    Speed(f64),
    /// Drive to a position.
    Position {
        /// Target angle, rad.
        angle: f64,
        /// Largest speed, rad/s.
        limit: f64,
    },
}

/// The speed for a command at an angle, rad/s.
#[function]
pub fn speed(command: &Command, angle: f64) -> f64 {
    match command {
        Command::Coast => 0.0,
        Command::Speed(speed) => *speed,
        Command::Position { angle: target, limit } => {
            (2.0 * (target - angle)).max(-limit).min(*limit)
        }
    }
}

/// The command for a lever: a speed if it is far from the middle.
#[function]
pub fn from_lever(lever: f64) -> Command {
    if lever.abs() > 0.1 { Command::Speed(10.0 * lever) } else { Command::Coast }
}

/// Halves the speed of a command.
#[function]
pub fn slower(command: &mut Command) {
    match command {
        Command::Speed(speed) => *speed /= 2.0,
        Command::Position { limit, .. } => *limit /= 2.0,
        Command::Coast => {}
    }
}
