//! Cosine and sine of an angle: a module of its function's name, from which the crate's root imports.

use bessemer::prelude::*;

/// Returns the cosine and the sine of an angle in rad.
#[function]
pub fn cossin(angle: f64) -> (f64, f64) {
    (angle.cos(), angle.sin())
}
