//! Integers of 64 bits, without a sign.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = u64;

/// A first value.
#[function]
pub fn one() -> It {
    1
}

/// A second, different value.
#[function]
pub fn other() -> It {
    u64::MAX
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = it.wrapping_add(5);
}

include!("six.in");
