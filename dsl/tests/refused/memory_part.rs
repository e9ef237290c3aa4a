#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A column to be written, by a name of its own.
#[function]
pub fn column(m: &mut Matrix3<f64>, j: usize) {
    let mut column = m.column_mut(j);
    column[0] = 1.0;
    let rows = m.rows(0, j);
    m[(0, 0)] = rows[(0, 0)];
}

fn main() {}
