#![no_std]
extern crate std;

use bessemer::prelude::*;

#[function]
fn raised(b: &mut f64, a: Matrix2<f64>) -> Matrix2<f64> {
    *b += 1.0;
    a
}

/// A closure that copies what its own statement changes.
#[function]
pub fn closures(a: Matrix2<f64>, mut b: f64) -> Matrix2<f64> {
    let c = a;
    c.zip_map(&raised(&mut b, a), move |x, y| x + y * b)
}

fn main() {}
