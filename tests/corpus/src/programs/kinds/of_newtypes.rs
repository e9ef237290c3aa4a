//! A number with a name of its own.

use bessemer::prelude::*;

/// A voltage, V.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Volts(pub f32);

/// The kind.
pub type It = Volts;
/// Its numbers.
pub type Number = f32;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    Volts(x)
}

/// One of them.
#[function]
pub fn one() -> It {
    Volts(-0.0)
}

/// Another.
#[function]
pub fn other() -> It {
    Volts(5.5)
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.0 += 1.0;
}

include!("six.in");
include!("floats.in");
