//! Views that are written stay where they are: one in a tuple, one in an array, and one that a branch chooses.
#![no_std]
use bessemer::prelude::*;

/// In a tuple.
#[function]
pub fn paired(m: &mut Matrix3<f64>) -> f64 {
    let pair = (m.column_mut(0), 1.0);
    pair.1
}

/// In an array.
#[function]
pub fn listed(m: &mut Matrix3<f64>) {
    for mut column in [m.column_mut(1)] {
        column[0] = 1.0;
    }
}

/// Chosen by a branch.
#[function]
pub fn chosen(m: &mut Matrix3<f64>, left: bool) {
    let mut column = if left { m.column_mut(0) } else { m.column_mut(2) };
    column[0] = 1.0;
}
