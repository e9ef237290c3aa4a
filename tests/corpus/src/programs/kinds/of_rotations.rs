//! Rotations as matrices.

use bessemer::prelude::*;

/// The kind.
pub type It = Rotation3<f64>;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    Rotation3::from_matrix_unchecked(Matrix3::repeat(x))
}

/// One of them.
#[function]
pub fn one() -> It {
    Rotation3::identity()
}

/// Another.
#[function]
pub fn other() -> It {
    Rotation3::from_matrix_unchecked(Matrix3::new(0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0))
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = it.transpose();
}

include!("six.in");
include!("floats.in");
