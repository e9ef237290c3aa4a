//! Poses: a translation and a rotation.

use bessemer::prelude::*;

/// The kind.
pub type It = Isometry3<f32>;
/// Its numbers.
pub type Number = f32;

/// One with a number of its own.
#[function]
pub fn with(x: Number) -> It {
    Isometry3::from_parts(Translation3::new(0.0, x, 0.0), UnitQuaternion::identity())
}

/// One of them.
#[function]
pub fn one() -> It {
    Isometry3::identity()
}

/// Another.
#[function]
pub fn other() -> It {
    Isometry3::from_parts(Translation3::new(1.0, 2.0, 3.0), UnitQuaternion::identity())
}

/// Makes it a third.
#[function]
pub fn change(it: &mut It) {
    it.translation.vector.x = 4.0;
}

include!("six.in");
include!("floats.in");
