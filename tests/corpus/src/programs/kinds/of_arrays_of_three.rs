//! Arrays of arrays of arrays.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = [[[u8; 2]; 3]; 2];

/// A first value.
#[function]
pub fn one() -> It {
    [[[1, 2], [3, 4], [5, 6]], [[7, 8], [9, 10], [11, 12]]]
}

/// A second, different value.
#[function]
pub fn other() -> It {
    [[[0; 2]; 3]; 2]
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it[1][2] = it[0][0];
}

include!("six.in");
