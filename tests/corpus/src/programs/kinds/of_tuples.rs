//! Tuples.

use bessemer::prelude::*;

/// The kind.
pub type It = (u8, f64, bool);
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    (3, x, false)
}

/// One of them.
#[function]
pub fn one() -> It {
    (1, 2.5, true)
}

/// Another.
#[function]
pub fn other() -> It {
    (0, -2.5, true)
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.1 += 1.0;
    it.2 = !it.2;
}

include!("six.in");
include!("floats.in");
