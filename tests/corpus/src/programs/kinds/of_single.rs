//! Numbers of 32 bits.

use bessemer::prelude::*;

/// The kind.
pub type It = f32;
/// Its numbers.
pub type Number = f32;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    x
}

/// One of them.
#[function]
pub fn one() -> It {
    -0.0
}

/// Another.
#[function]
pub fn other() -> It {
    1.5
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = -*it;
}

include!("six.in");
include!("floats.in");
