//! Structs of words.

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

/// The kind.
pub type It = Reading;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    Reading { value: x, ..Reading::default() }
}

/// One of them.
#[function]
pub fn one() -> It {
    Reading { sensor: 3, value: 1.0e-7, count: -4, on: true }
}

/// Another.
#[function]
pub fn other() -> It {
    Reading::default()
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.value = 2.0;
    it.count = i64::MAX;
}

include!("six.in");
include!("floats.in");
