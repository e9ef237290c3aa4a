//! Arrays that a loop fills only partly, or reads while it fills them, keep their initial zeros.

use bessemer::prelude::*;

/// All elements but the last are filled.
#[function]
pub fn all_but_one(x: f64) -> [f64; 5] {
    let mut list = [0.0; 5];
    for i in 0..4 {
        list[i] = x;
    }
    list
}

/// An element is filled only if a condition holds.
#[function]
pub fn where_it_holds(x: &[f64; 4]) -> [f64; 4] {
    let mut list = [0.0; 4];
    for i in 0..4 {
        if x[i] > 0.0 {
            list[i] = x[i];
        }
    }
    list
}

/// Elements after a `break` are not filled.
#[function]
pub fn until(x: &[i32; 4]) -> [i32; 4] {
    let mut list = [7; 4];
    for i in 0..4 {
        if x[i] < 0 {
            break;
        }
        list[i] = 1;
    }
    list
}

/// Each element is computed from the one before.
#[function]
pub fn summed(x: &Vector4<f64>) -> Vector4<f64> {
    let mut sums = Vector4::zeros();
    for i in 0..4 {
        let before = if i > 0 { sums[i - 1] } else { sums[3] };
        sums[i] = before + x[i];
    }
    sums
}

/// Only the diagonal is filled.
#[function]
pub fn diagonal(x: f32) -> Matrix3<f32> {
    let mut matrix = Matrix3::zeros();
    for i in 0..3 {
        matrix[(i, i)] = x;
    }
    matrix
}

/// Only one column is filled; and the transpose of a filled matrix.
#[function]
pub fn column(x: f64) -> (SMatrix<f64, 2, 3>, SMatrix<f64, 2, 2>) {
    let mut matrix = SMatrix::<f64, 2, 3>::zeros();
    for row in 0..2 {
        matrix[(row, 1)] = x;
    }
    let mut square = SMatrix::<f64, 2, 2>::zeros();
    for i in 0..2 {
        for j in 0..2 {
            square[(i, j)] = x + i as f64;
        }
    }
    (matrix, square)
}

/// All elements are filled, in each branch, and in reverse order.
#[function]
pub fn whole(x: &[f64; 4], turn: bool) -> [f64; 4] {
    let mut list = [0.0; 4];
    for i in (0..4).rev() {
        if turn {
            list[i] = x[3 - i];
        } else {
            list[i] = x[i];
        }
    }
    list
}
