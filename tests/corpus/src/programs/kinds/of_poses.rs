//! Poses: a translation and a rotation.

use bessemer::prelude::*;

/// The type of this kind.
pub type It = Isometry3<f32>;
/// The type of its numbers.
pub type Number = f32;

/// A value that contains the number `x`.
#[function]
pub fn with(x: Number) -> It {
    Isometry3::from_parts(Translation3::new(0.0, x, 0.0), UnitQuaternion::identity())
}

/// A first value.
#[function]
pub fn one() -> It {
    Isometry3::identity()
}

/// A second, different value.
#[function]
pub fn other() -> It {
    Isometry3::from_parts(Translation3::new(1.0, 2.0, 3.0), UnitQuaternion::identity())
}

/// Changes the value to a third one.
#[function]
pub fn change(it: &mut It) {
    it.translation.vector.x = 4.0;
}

include!("six.in");
include!("floats.in");
