//! Modules of one last name, each with a type of one name, and options of both.

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
