//! `assert!` states what a caller has to keep; its message is for the simulation.

use bessemer::prelude::*;

/// The share of a part in a whole.
#[function]
pub fn share(part: f64, whole: f64) -> f64 {
    assert!(whole > 0.0, "the whole must be positive");
    assert_ne!(part, whole, "some must be left");
    part / whole
}
