//! Calls whose result is moved into a struct by `return`: in one branch or several, read before, used twice.

use bessemer::prelude::*;

/// A function that is not inlined.
#[function]
pub fn squared(a: &Matrix3<f64>) -> Matrix3<f64> {
    a * a
}

/// Two matrices and an element.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Both {
    /// First matrix.
    pub first: Matrix3<f64>,
    /// Second matrix.
    pub second: Matrix3<f64>,
    /// An element of a matrix.
    pub corner: f64,
}

/// The result is read, and then one branch returns it.
#[function]
pub fn read_before(a: &Matrix3<f64>) -> Option<Matrix3<f64>> {
    let square = squared(a);
    let trace = square[(0, 0)] + square[(1, 1)] + square[(2, 2)];
    if trace > 0.0 { Some(square) } else { None }
}

/// Two results that would have the same place in the struct.
#[function]
pub fn one_of_two(a: &Matrix3<f64>, b: &Matrix3<f64>) -> Option<Matrix3<f64>> {
    let left = squared(a);
    let right = squared(b);
    if left[(0, 0)] > right[(0, 0)] {
        return Some(left);
    }
    if right[(0, 1)] > 0.0 { Some(right) } else { None }
}

/// Two results with exchanged places, and an element of one.
#[function]
pub fn crossed(a: &Matrix3<f64>, b: &Matrix3<f64>) -> Both {
    let first = squared(a);
    let second = squared(b);
    if first[(2, 2)] > second[(2, 2)] {
        return Both { first: second, second: first, corner: 0.0 };
    }
    Both { first, second, corner: second[(1, 0)] }
}

/// Two results, and a computation from them in the other branch.
#[function]
pub fn twice(a: &Matrix3<f64>) -> Both {
    let square = squared(a);
    if a[(0, 0)] > 0.0 {
        return Both { first: square, second: square, corner: 1.0 };
    }
    Both { first: *a, second: square + a, corner: 2.0 }
}

/// A field of a field, read in a loop.
#[function]
pub fn nested(a: &Matrix3<f64>, b: &Matrix3<f64>) -> Option<Both> {
    let first = squared(a);
    let second = squared(b);
    let mut corner = 0.0;
    for k in 0..3 {
        corner += first[(k, k)] * second[(0, k)];
    }
    if corner > 0.0 { Some(Both { first, second, corner }) } else { None }
}

/// The result is changed after the call.
#[function]
pub fn changed(a: &Matrix3<f64>) -> Option<Matrix3<f64>> {
    let mut square = squared(a);
    square[(0, 0)] -= 1.0;
    if square[(0, 0)] > 0.0 { Some(square) } else { None }
}

/// An error that contains a result, too.
#[function]
pub fn either(a: &Matrix3<f64>) -> Result<Matrix3<f64>, Vector3<f64>> {
    let square = squared(a);
    let column = a * Vector3::new(1.0, 2.0, 3.0);
    if column[0] > square[(0, 0)] { Ok(square) } else { Err(column) }
}
