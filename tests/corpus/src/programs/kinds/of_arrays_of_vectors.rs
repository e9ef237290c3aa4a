//! Arrays of vectors.

use bessemer::prelude::*;

/// The kind.
pub type It = [Vector2<f32>; 3];
/// Its numbers.
pub type Number = f32;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    [Vector2::new(x, 0.0); 3]
}

/// One of them.
#[function]
pub fn one() -> It {
    [Vector2::new(1.0, 2.0), Vector2::new(3.0, 4.0), Vector2::new(5.0, 6.0)]
}

/// Another.
#[function]
pub fn other() -> It {
    [Vector2::zeros(); 3]
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it[2].x = 0.5;
    it[0] = it[2];
}

include!("six.in");
include!("floats.in");
