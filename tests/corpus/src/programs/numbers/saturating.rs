//! `saturating_…` stops at the limits of its type.

use bessemer::prelude::*;

/// An integrator of a fixed-point regulator that stays at its limit.
#[function]
pub fn integrated(sum: i16, error: i16) -> i16 {
    sum.saturating_add(error.saturating_mul(3))
}
