//! Truth values.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = bool;

/// A first value.
#[function]
pub fn one() -> It {
    true
}

/// A second, different value.
#[function]
pub fn other() -> It {
    false
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = !*it;
}

include!("six.in");
