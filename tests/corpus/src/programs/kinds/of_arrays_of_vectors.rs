//! Arrays of vectors.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = [Vector2<f32>; 3];
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    [Vector2::new(x, 0.0); 3]
}

/// A first value.
#[function]
pub fn one() -> It {
    [Vector2::new(1.0, 2.0), Vector2::new(3.0, 4.0), Vector2::new(5.0, 6.0)]
}

/// A second, different value.
#[function]
pub fn other() -> It {
    [Vector2::zeros(); 3]
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it[2].x = 0.5;
    it[0] = it[2];
}

include!("six.in");
include!("floats.in");
