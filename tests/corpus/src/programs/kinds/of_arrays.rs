//! Arrays.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = [i32; 5];

/// A first value.
#[function]
pub fn one() -> It {
    [1, -2, 3, -4, i32::MIN]
}

/// A second, different value.
#[function]
pub fn other() -> It {
    [0; 5]
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it[3] = it[4];
}

include!("six.in");
