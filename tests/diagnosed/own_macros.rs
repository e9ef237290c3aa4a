//! Macros of an author's own that are named as Rust's and nalgebra's are.
#![no_std]
use bessemer::prelude::*;

macro_rules! assert {
    ($condition:expr) => {
        if !$condition {
            return 0.0;
        }
    };
}

macro_rules! vector {
    ($x:expr, $y:expr) => {
        $x * $y
    };
}

mod checks {
    macro_rules! is_never {
        ($value:expr, $pattern:pat) => {
            false
        };
    }
    pub(crate) use is_never as matches;
}
use checks::matches;

/// In the text above.
#[function]
pub fn quotient(a: f64, b: f64) -> f64 {
    assert!(b != 0.0);
    a / b
}

/// Imported.
#[function]
pub fn is_small(x: i32) -> bool {
    matches!(x, 0..=9)
}

/// Area from numbers.
#[function]
pub fn area(x: f64) -> f64 {
    vector![x, 2.0]
}
