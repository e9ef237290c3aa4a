//! Enums with payloads.

use bessemer::prelude::*;

/// Commands of a motor.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ServoOrder {
    /// Nothing.
    #[default]
    Coast,
    /// A speed, rad/s.
    Speed(f64),
    /// Target position and its parameters.
    Position { angle: f32, steps: [u16; 3], hold: bool },
}

/// The kind.
pub type It = ServoOrder;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    ServoOrder::Speed(x)
}

/// One of them.
#[function]
pub fn one() -> It {
    ServoOrder::Position { angle: 0.5, steps: [1, 2, 3], hold: true }
}

/// Another.
#[function]
pub fn other() -> It {
    ServoOrder::Speed(-1.0)
}

/// Makes it a third.
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
