//! Modules with the same last name, each with a type of the same name, and options of both types.

use bessemer::prelude::*;

pub mod first;
pub mod second;

#[function]
pub fn both(a: i32, b: f64) -> f64 {
    let first = first::state::positive(a);
    let second = second::state::positive(b);
    match (first, second) {
        (Some(one), Some(other)) => f64::from(one.value) + other.value,
        (Some(one), None) => f64::from(one.value),
        (None, Some(other)) => other.value,
        (None, None) => -1.0,
    }
}
