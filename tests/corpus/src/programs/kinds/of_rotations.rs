//! Rotations as matrices.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = Rotation3<f64>;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    Rotation3::from_matrix_unchecked(Matrix3::repeat(x))
}

/// A first value.
#[function]
pub fn one() -> It {
    Rotation3::identity()
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Rotation3::from_matrix_unchecked(Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0))
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = it.transpose();
}

include!("six.in");
include!("floats.in");
