//! Floats of 32 bits.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = f32;
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    x
}

/// A first value.
#[function]
pub fn one() -> It {
    -0.0
}

/// A second, different value.
#[function]
pub fn other() -> It {
    1.5
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = -*it;
}

include!("six.in");
include!("floats.in");
