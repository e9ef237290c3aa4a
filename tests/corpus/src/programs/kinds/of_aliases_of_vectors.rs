//! nalgebra's names for small ones.

use bessemer::nalgebra::RowVector2;
use bessemer::prelude::*;

/// The kind.
pub type It = (Vector3<f64>, RowVector2<f32>, Matrix2<f64>);
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    (Vector3::zeros(), RowVector2::zeros(), Matrix2::new(0.0, x, 0.0, 0.0))
}

/// One of them.
#[function]
pub fn one() -> It {
    (Vector3::new(1.0, 2.0, 3.0), RowVector2::new(4.0, 5.0), Matrix2::identity())
}

/// Another.
#[function]
pub fn other() -> It {
    (Vector3::zeros(), RowVector2::zeros(), Matrix2::zeros())
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.0.y = 9.0;
    it.2 = Matrix2::new(1.0, 2.0, 3.0, 4.0);
}

include!("six.in");
include!("floats.in");
