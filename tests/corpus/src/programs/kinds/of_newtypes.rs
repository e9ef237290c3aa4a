//! A newtype of a number.

use bessemer::prelude::*;

/// A voltage, V.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Volts(pub f32);

/// The type of this kind.
pub type It = Volts;
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    Volts(x)
}

/// A first value.
#[function]
pub fn one() -> It {
    Volts(-0.0)
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Volts(5.5)
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.0 += 1.0;
}

include!("six.in");
include!("floats.in");
