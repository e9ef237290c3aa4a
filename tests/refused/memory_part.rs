#![no_std]
extern crate std;

use bessemer::prelude::*;

/// As many rows as a number says.
#[function]
pub fn column(m: &mut Matrix3<f64>, j: usize) {
    let rows = m.rows(0, j);
    m[(0, 0)] = rows[(0, 0)];
}

fn main() {}
