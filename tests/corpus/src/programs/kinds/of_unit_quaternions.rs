//! Rotations as quaternions.

use bessemer::prelude::*;

/// The kind.
pub type It = UnitQuaternion<f64>;
/// Its numbers.
pub type Number = f64;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    UnitQuaternion::new_unchecked(Quaternion::new(x, 0.0, 0.0, 1.0))
}

/// One of them.
#[function]
pub fn one() -> It {
    UnitQuaternion::identity()
}

/// Another.
#[function]
pub fn other() -> It {
    UnitQuaternion::new_normalize(Quaternion::new(1.0, 2.0, 3.0, 4.0))
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    *it = it.inverse();
}

include!("six.in");
include!("floats.in");
