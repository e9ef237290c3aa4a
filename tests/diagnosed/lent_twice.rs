//! Two values that refer to elements of one array, and one that refers to an element of a matrix.
#![no_std]
use bessemer::prelude::*;

/// Exchanges what two refer to.
#[function]
pub fn exchange(one: Option<&mut u8>, other: Option<&mut u8>) {
    if let (Some(one), Some(other)) = (one, other) {
        core::mem::swap(one, other);
    }
}

/// Borrows of the halves of an array.
#[function]
pub fn halves(values: &mut [u8; 8], sought: u8) {
    let (low, high) = values.split_at_mut(4);
    exchange(low.iter_mut().find(|x| **x == sought), high.first_mut());
}

/// Borrows of a matrix.
#[function]
pub fn of_matrix(m: &mut Matrix3<f64>) -> f64 {
    let low = 3.0;
    if let Some(x) = m.iter_mut().find(|x| **x > low) {
        *x = low;
    }
    m[(0, 0)]
}
