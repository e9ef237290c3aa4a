//! `==` of structs, arrays and matrices compares part by part, floats as IEEE 754 has it.

use bessemer::prelude::*;

/// Destination.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Target {
    pub position: Vector3<f64>,
    pub land: bool,
}

/// Returns true if an order is a new one.
#[function]
pub fn is_new(before: &Target, now: &Target) -> bool {
    before != now
}

/// Returns true if two plans are the same.
#[function]
pub fn same_plan(one: &[Target; 6], other: &[Target; 6]) -> bool {
    one == other
}
