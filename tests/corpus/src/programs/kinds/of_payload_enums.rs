//! Enums with payloads.

use bessemer::prelude::*;

/// Commands of a motor.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ServoOrder {
    /// No drive.
    #[default]
    Coast,
    /// Drive at a speed, rad/s.
    Speed(f64),
    /// Drive to a position.
    Position { angle: f32, steps: [u16; 3], hold: bool },
}

/// The type of this kind.
pub type It = ServoOrder;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    ServoOrder::Speed(x)
}

/// A first value.
#[function]
pub fn one() -> It {
    ServoOrder::Position { angle: 0.5, steps: [1, 2, 3], hold: true }
}

/// A second, different value.
#[function]
pub fn other() -> It {
    ServoOrder::Speed(-1.0)
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = match *it {
        ServoOrder::Coast => ServoOrder::Speed(2.0),
        ServoOrder::Speed(_) => one(),
        ServoOrder::Position { .. } => ServoOrder::Coast,
    };
}

include!("six.in");
include!("floats.in");
