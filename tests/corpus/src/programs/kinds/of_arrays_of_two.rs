//! Arrays of arrays.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = [[f32; 3]; 2];
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    [[x; 3], [0.0, x, 1.0]]
}

/// A first value.
#[function]
pub fn one() -> It {
    [[0.0, 1.0, 2.0], [3.0, 4.0, 5.0]]
}

/// A second, different value.
#[function]
pub fn other() -> It {
    [[0.5; 3]; 2]
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it[1] = it[0];
}

include!("six.in");
include!("floats.in");
