//! `assert!` states a condition that callers must satisfy; its message is for the simulation.

use bessemer::prelude::*;

/// The ratio of a part to the whole.
#[function]
pub fn share(part: f64, whole: f64) -> f64 {
    assert!(whole > 0.0, "the whole must be positive");
    assert_ne!(part, whole, "some must be left");
    part / whole
}
