//! Integers of 8 bits, without a sign.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = u8;

/// A first value.
#[function]
pub fn one() -> It {
    1
}

/// A second, different value.
#[function]
pub fn other() -> It {
    u8::MAX
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = it.wrapping_add(5);
}

include!("six.in");
