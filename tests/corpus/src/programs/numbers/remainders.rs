//! `%` has the sign of the left side; `rem_euclid` is never negative.

use bessemer::prelude::*;

/// The index in a ring of 12 after a step in either direction.
#[function]
pub fn in_ring(place: i32, step: i8) -> i32 {
    (place % 12 + i32::from(step)).rem_euclid(12)
}

/// An angle wrapped to a full turn, rad.
#[function]
pub fn wrapped(angle: f64) -> f64 {
    angle.rem_euclid(core::f64::consts::TAU)
}
