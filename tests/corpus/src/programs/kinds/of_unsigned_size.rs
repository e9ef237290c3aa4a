//! Sizes and indices (`usize`): 64 bits on every target.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = usize;

/// A first value.
#[function]
pub fn one() -> It {
    usize::MAX
}

/// A second, different value.
#[function]
pub fn other() -> It {
    0
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = it.wrapping_add(5);
}

include!("six.in");
