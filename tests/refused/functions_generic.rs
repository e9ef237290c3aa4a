#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Hides its type.
#[function]
pub fn hidden(x: impl Into<f64>) -> impl Copy {
    x.into()
}

fn main() {}
