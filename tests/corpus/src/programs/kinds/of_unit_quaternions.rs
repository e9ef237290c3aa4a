//! Rotations as quaternions.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = UnitQuaternion<f64>;
/// The type of its numbers.
pub type Number = f64;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    UnitQuaternion::new_unchecked(Quaternion::new(x, 0.0, 0.0, 1.0))
}

/// A first value.
#[function]
pub fn one() -> It {
    UnitQuaternion::identity()
}

/// A second, different value.
#[function]
pub fn other() -> It {
    UnitQuaternion::new_normalize(Quaternion::new(1.0, 2.0, 3.0, 4.0))
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    *it = it.inverse();
}

include!("six.in");
include!("floats.in");
