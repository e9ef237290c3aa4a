//! Integers of 16 bits, with a sign.

use bessemer::prelude::*;

/// The kind.
pub type It = i16;

/// One of them.
#[function]
pub fn one() -> It {
    i16::MIN
}

/// Another.
#[function]
pub fn other() -> It {
    i16::MAX
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = it.wrapping_sub(3);
}

include!("six.in");
