//! Arrays that a loop fills partly, or reads before it fills them, keep their initial zeros.

use bessemer::prelude::*;

/// All but the last.
#[function]
pub fn all_but_one(x: f64) -> [f64; 5] {
    let mut list = [0.0; 5];
    for i in 0..4 {
        list[i] = x;
    }
    list
}

/// Only where something holds.
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

/// Not after a break.
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

/// Each from the one before.
#[function]
pub fn summed(x: &Vector4<f64>) -> Vector4<f64> {
    let mut sums = Vector4::zeros();
    for i in 0..4 {
        let before = if i > 0 { sums[i - 1] } else { sums[3] };
        sums[i] = before + x[i];
    }
    sums
}

/// Only the diagonal.
#[function]
pub fn diagonal(x: f32) -> Matrix3<f32> {
    let mut matrix = Matrix3::zeros();
    for i in 0..3 {
        matrix[(i, i)] = x;
    }
    matrix
}

/// Only one column, and the transpose of what is filled.
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

/// Whole, in each branch, and from behind.
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
