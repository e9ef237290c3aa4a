//! The attribute of components on a function.
use bessemer::prelude::*;

#[component]
pub fn double(x: f64) -> f64 {
    2.0 * x
}
