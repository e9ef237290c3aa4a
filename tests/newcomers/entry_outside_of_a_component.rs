//! A plain function as an entry.
use bessemer::prelude::*;

#[entry]
pub fn step(x: f64) -> f64 {
    2.0 * x
}
