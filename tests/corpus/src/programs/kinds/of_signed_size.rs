//! Differences of sizes: 64 bits on every target.

use bessemer::prelude::*;

/// The kind.
pub type It = isize;

/// One of them.
#[function]
pub fn one() -> It {
    isize::MIN
}

/// Another.
#[function]
pub fn other() -> It {
    -1
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = it.wrapping_sub(3);
}

include!("six.in");
