//! An index is checked, unless its loop, a comparison or a constant bounds it.

use bessemer::prelude::*;

/// An element at the caller's index, which needs a check.
#[function]
pub fn element(table: &[f64; 4], at: usize) -> f64 {
    table[at]
}

/// An element at a compared index, which needs no check.
#[function]
pub fn guarded(table: &[f64; 4], at: usize) -> f64 {
    if at < 4 { table[at] } else { 0.0 }
}

/// An element at a masked index, which needs no check.
#[function]
pub fn masked(table: &[f64; 4], at: usize) -> f64 {
    table[at % 4]
}
