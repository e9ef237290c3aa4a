//! Structs of numbers.

use bessemer::prelude::*;

/// Reading of a sensor.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reading {
    pub sensor: u8,
    pub value: f64,
    pub count: i64,
    pub on: bool,
}

/// The type of this kind.
pub type It = Reading;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    Reading { value: x, ..Reading::default() }
}

/// A first value.
#[function]
pub fn one() -> It {
    Reading { sensor: 3, value: 1.0e-7, count: -4, on: true }
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Reading::default()
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.value = 2.0;
    it.count = i64::MAX;
}

include!("six.in");
include!("floats.in");
