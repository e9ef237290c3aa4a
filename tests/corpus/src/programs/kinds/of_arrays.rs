//! Arrays.

use bessemer::prelude::*;

/// The kind.
pub type It = [i32; 5];

/// One of them.
#[function]
pub fn one() -> It {
    [1, -2, 3, -4, i32::MIN]
}

/// Another.
#[function]
pub fn other() -> It {
    [0; 5]
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it[3] = it[4];
}

include!("six.in");
