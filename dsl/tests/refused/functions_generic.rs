#![no_std]
extern crate std;

use bessemer::prelude::*;

/// For any type, and any length.
#[function]
pub fn first<T: Copy, const N: usize>(values: [T; N]) -> T {
    values[0]
}

/// Hides its type.
#[function]
pub fn hidden(x: impl Into<f64>) -> impl Copy {
    x.into()
}

fn main() {}
