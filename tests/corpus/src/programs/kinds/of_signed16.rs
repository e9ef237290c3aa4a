//! Integers of 16 bits, with a sign.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = i16;

/// A first value.
#[function]
pub fn one() -> It {
    i16::MIN
}

/// A second, different value.
#[function]
pub fn other() -> It {
    i16::MAX
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = it.wrapping_sub(3);
}

include!("six.in");
