//! Arrays of arrays.

use bessemer::prelude::*;

/// The kind.
pub type It = [[f32; 3]; 2];
/// Its numbers.
pub type Number = f32;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    [[x; 3], [0.0, x, 1.0]]
}

/// One of them.
#[function]
pub fn one() -> It {
    [[0.0, 1.0, 2.0], [3.0, 4.0, 5.0]]
}

/// Another.
#[function]
pub fn other() -> It {
    [[0.5; 3]; 2]
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it[1] = it[0];
}

include!("six.in");
include!("floats.in");
