//! nalgebra's aliases of small vectors and matrices.

use bessemer::nalgebra::RowVector2;
use bessemer::prelude::*;

/// The type of this kind.
pub type It = (Vector3<f64>, RowVector2<f32>, Matrix2<f64>);
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    (Vector3::zeros(), RowVector2::zeros(), Matrix2::new(0.0, x, 0.0, 0.0))
}

/// A first value.
#[function]
pub fn one() -> It {
    (Vector3::new(1.0, 2.0, 3.0), RowVector2::new(4.0, 5.0), Matrix2::identity())
}

/// A second, different value.
#[function]
pub fn other() -> It {
    (Vector3::zeros(), RowVector2::zeros(), Matrix2::zeros())
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.0.y = 9.0;
    it.2 = Matrix2::new(1.0, 2.0, 3.0, 4.0);
}

include!("six.in");
include!("floats.in");
