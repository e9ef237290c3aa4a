//! Sizes and indices: 64 bits on every target.

use bessemer::prelude::*;

/// The kind.
pub type It = usize;

/// One of them.
#[function]
pub fn one() -> It {
    usize::MAX
}

/// Another.
#[function]
pub fn other() -> It {
    0
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = it.wrapping_add(5);
}

include!("six.in");
