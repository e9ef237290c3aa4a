//! Tuples in tuples, with arrays.

use bessemer::prelude::*;

/// The kind.
pub type It = ((u8, (f32, bool)), [(i16, u64); 2]);
/// Its numbers.
pub type Number = f32;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    ((9, (x, true)), [(1, 2), (3, 4)])
}

/// One of them.
#[function]
pub fn one() -> It {
    ((1, (0.5, true)), [(2, 3), (-4, u64::MAX)])
}

/// Another.
#[function]
pub fn other() -> It {
    ((0, (0.0, false)), [(0, 0); 2])
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.1[0] = it.1[1];
    (it.0).1.0 = 7.0;
}

include!("six.in");
include!("floats.in");
