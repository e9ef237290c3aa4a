//! `==` of structs, arrays and matrices compares part by part, floats as IEEE 754 has it.

use bessemer::prelude::*;

/// Where to go.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Target {
    pub position: Vector3<f64>,
    pub land: bool,
}

/// Whether an order is a new one.
#[function]
pub fn is_new(before: &Target, now: &Target) -> bool {
    before != now
}

/// Whether two plans are the same.
#[function]
pub fn same_plan(one: &[Target; 6], other: &[Target; 6]) -> bool {
    one == other
}
