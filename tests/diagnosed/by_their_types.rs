//! Methods that a type of Rust's or nalgebra's has, or that is generic, with what to write in their place.
#![no_std]
use bessemer::prelude::*;

/// What is generic.
#[function]
pub fn median<T: Ord + Copy>(a: T, b: T, c: T) -> T {
    a.max(b).min(c)
}

/// What a matrix has in nalgebra, and the decomposition in the DSL.
#[function]
pub fn inverted(a: &Matrix3x2<f64>) -> Matrix2x3<f64> {
    a.pseudo_inverse(1e-9).unwrap()
}

/// Of numbers.
#[function]
pub fn roots(x: u32, y: f64) -> f64 {
    f64::from(x.isqrt() + x.saturating_pow(2)) + y.midpoint(7.0)
}
