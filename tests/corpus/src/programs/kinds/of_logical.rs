//! Truth values.

use bessemer::prelude::*;

/// The kind.
pub type It = bool;

/// One of them.
#[function]
pub fn one() -> It {
    true
}

/// Another.
#[function]
pub fn other() -> It {
    false
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = !*it;
}

include!("six.in");
