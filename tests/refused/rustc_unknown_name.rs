#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A slip of the pen.
#[function]
pub fn slip(height: f64) -> f64 {
    heigth + undefined(height)
}

fn main() {}
