//! `saturating_…` stops at the limits of its type.

use bessemer::prelude::*;

/// The integral of a fixed-point controller, limited to its type.
#[function]
pub fn integrated(sum: i16, error: i16) -> i16 {
    sum.saturating_add(error.saturating_mul(3))
}
