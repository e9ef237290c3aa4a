//! Tuples.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = (u8, f64, bool);
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    (3, x, false)
}

/// A first value.
#[function]
pub fn one() -> It {
    (1, 2.5, true)
}

/// A second, different value.
#[function]
pub fn other() -> It {
    (0, -2.5, true)
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.1 += 1.0;
    it.2 = !it.2;
}

include!("six.in");
include!("floats.in");
