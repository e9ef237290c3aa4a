//! Integers of 8 bits, with a sign.

use bessemer::prelude::*;

/// The kind.
pub type It = i8;

/// One of them.
#[function]
pub fn one() -> It {
    i8::MIN
}

/// Another.
#[function]
pub fn other() -> It {
    i8::MAX
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = it.wrapping_sub(3);
}

include!("six.in");
