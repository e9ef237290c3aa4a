//! Arrays of arrays of arrays.

use bessemer::prelude::*;

/// The kind.
pub type It = [[[u8; 2]; 3]; 2];

/// One of them.
#[function]
pub fn one() -> It {
    [[[1, 2], [3, 4], [5, 6]], [[7, 8], [9, 10], [11, 12]]]
}

/// Another.
#[function]
pub fn other() -> It {
    [[[0; 2]; 3]; 2]
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it[1][2] = it[0][0];
}

include!("six.in");
