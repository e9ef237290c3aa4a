//! Signed sizes (`isize`): 64 bits on every target.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = isize;

/// A first value.
#[function]
pub fn one() -> It {
    isize::MIN
}

/// A second, different value.
#[function]
pub fn other() -> It {
    -1
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = it.wrapping_sub(3);
}

include!("six.in");
