//! Methods of an author's own type that are called as those of `bool` are.
#![no_std]
use bessemer::prelude::*;

/// A switch.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Switch {
    /// Whether it is on.
    pub on: bool,
}

#[data]
impl Switch {
    /// The value while it is off.
    pub fn then_some(self, value: f64) -> Option<f64> {
        if self.on { None } else { Some(value) }
    }
}

/// Not the one of `bool`.
#[function]
pub fn chosen(switch: Switch, value: f64) -> Option<f64> {
    switch.then_some(value)
}
