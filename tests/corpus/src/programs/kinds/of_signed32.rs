//! Integers of 32 bits, with a sign.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = i32;

/// A first value.
#[function]
pub fn one() -> It {
    i32::MIN
}

/// A second, different value.
#[function]
pub fn other() -> It {
    i32::MAX
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = it.wrapping_sub(3);
}

include!("six.in");
