//! An enum without payloads is a C `enum`; its variants have the enum's name as a prefix.

use bessemer::prelude::*;

/// State of the lamp.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lamp {
    #[default]
    Off,
    Blinking,
    On,
}

#[data]
impl Lamp {
    /// Next state.
    pub fn next(self) -> Lamp {
        match self {
            Lamp::Off => Lamp::Blinking,
            Lamp::Blinking => Lamp::On,
            Lamp::On => Lamp::Off,
        }
    }
}

/// The lamp after `presses` of its button.
#[function]
pub fn pressed(lamp: Lamp, presses: u8) -> Lamp {
    let mut lamp = lamp;
    for _ in 0..presses % 3 {
        lamp = lamp.next();
    }
    lamp
}
