//! A case.
#![no_std]
use bessemer::prelude::*;

/// A matrix routine that the DSL does not know.
#[function]
pub fn caller(m: &Matrix3<f64>) -> f64 {
    (m.rank(1e-9) + m.rank(1e-6)) as f64
}

/// Misspelt, of lists and of numbers.
#[function]
pub fn misspelt(queue: &mut List<u8, 4>, level: i32) -> i32 {
    queue.insret(0, 1);
    level.sqare()
}
