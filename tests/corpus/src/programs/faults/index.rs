//! An index is checked, unless its loop, a comparison or a constant bounds it.

use bessemer::prelude::*;

/// An element that someone else names: a check is left.
#[function]
pub fn element(table: &[f64; 4], at: usize) -> f64 {
    table[at]
}

/// Guarded: no check is left.
#[function]
pub fn guarded(table: &[f64; 4], at: usize) -> f64 {
    if at < 4 { table[at] } else { 0.0 }
}

/// Masked: no check is left.
#[function]
pub fn masked(table: &[f64; 4], at: usize) -> f64 {
    table[at % 4]
}
