//! `==` of structs, arrays and matrices compares element by element; floats compare as in IEEE 754.

use bessemer::prelude::*;

/// Destination.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Target {
    pub position: Vector3<f64>,
    pub land: bool,
}

/// Returns true if the target has changed.
#[function]
pub fn is_new(before: &Target, now: &Target) -> bool {
    before != now
}

/// Returns true if two plans are equal.
#[function]
pub fn same_plan(one: &[Target; 6], other: &[Target; 6]) -> bool {
    one == other
}
