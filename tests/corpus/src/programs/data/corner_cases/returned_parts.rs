//! Parts that calls fill and a `return` moves into its struct: in one branch or several, read before, used twice.

use bessemer::prelude::*;

/// Not one that stands where it is used.
#[function]
pub fn squared(a: &Matrix3<f64>) -> Matrix3<f64> {
    a * a
}

/// A pair.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Both {
    /// One.
    pub first: Matrix3<f64>,
    /// Another.
    pub second: Matrix3<f64>,
    /// An element.
    pub corner: f64,
}

/// Its words are read, then one branch returns it.
#[function]
pub fn read_before(a: &Matrix3<f64>) -> Option<Matrix3<f64>> {
    let square = squared(a);
    let trace = square[(0, 0)] + square[(1, 1)] + square[(2, 2)];
    if trace > 0.0 { Some(square) } else { None }
}

/// Two that would be the same part.
#[function]
pub fn one_of_two(a: &Matrix3<f64>, b: &Matrix3<f64>) -> Option<Matrix3<f64>> {
    let left = squared(a);
    let right = squared(b);
    if left[(0, 0)] > right[(0, 0)] {
        return Some(left);
    }
    if right[(0, 1)] > 0.0 { Some(right) } else { None }
}

/// Parts that change places, and an element of one beside them.
#[function]
pub fn crossed(a: &Matrix3<f64>, b: &Matrix3<f64>) -> Both {
    let first = squared(a);
    let second = squared(b);
    if first[(2, 2)] > second[(2, 2)] {
        return Both { first: second, second: first, corner: 0.0 };
    }
    Both { first, second, corner: second[(1, 0)] }
}

/// Two such parts, and the other branch's computation from them.
#[function]
pub fn twice(a: &Matrix3<f64>) -> Both {
    let square = squared(a);
    if a[(0, 0)] > 0.0 {
        return Both { first: square, second: square, corner: 1.0 };
    }
    Both { first: *a, second: square + a, corner: 2.0 }
}

/// Part of a part, read within a loop.
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

/// Changed after the call.
#[function]
pub fn changed(a: &Matrix3<f64>) -> Option<Matrix3<f64>> {
    let mut square = squared(a);
    square[(0, 0)] -= 1.0;
    if square[(0, 0)] > 0.0 { Some(square) } else { None }
}

/// An error that holds one, too.
#[function]
pub fn either(a: &Matrix3<f64>) -> Result<Matrix3<f64>, Vector3<f64>> {
    let square = squared(a);
    let column = a * Vector3::new(1.0, 2.0, 3.0);
    if column[0] > square[(0, 0)] { Ok(square) } else { Err(column) }
}
