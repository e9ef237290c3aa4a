//! Tuples in tuples, with arrays.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = ((u8, (f32, bool)), [(i16, u64); 2]);
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    ((9, (x, true)), [(1, 2), (3, 4)])
}

/// A first value.
#[function]
pub fn one() -> It {
    ((1, (0.5, true)), [(2, 3), (-4, u64::MAX)])
}

/// A second, different value.
#[function]
pub fn other() -> It {
    ((0, (0.0, false)), [(0, 0); 2])
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.1[0] = it.1[1];
    (it.0).1.0 = 7.0;
}

include!("six.in");
include!("floats.in");
