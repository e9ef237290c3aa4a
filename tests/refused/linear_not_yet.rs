#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A closure that moves what may change.
#[function]
pub fn closures(a: Matrix2<f64>, mut b: f64) -> Matrix2<f64> {
    b += 1.0;
    let c = a;
    c.zip_map(&a, move |x, y| x + y * b)
}

fn main() {}
