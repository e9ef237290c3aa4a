//! Integers of 32 bits, without a sign.

use bessemer::prelude::*;

/// The kind.
pub type It = u32;

/// One of them.
#[function]
pub fn one() -> It {
    1
}

/// Another.
#[function]
pub fn other() -> It {
    u32::MAX
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = it.wrapping_add(5);
}

include!("six.in");
