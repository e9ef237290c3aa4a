//! Single precision remains single: literals and functions have the type `float`.

use bessemer::prelude::*;

/// A second-order polynomial and a root.
#[function]
pub fn corrected(x: f32) -> f32 {
    let y = 0.25 * x * x - 1.5 * x + 0.1;
    (y * y + 1.0).sqrt()
}
