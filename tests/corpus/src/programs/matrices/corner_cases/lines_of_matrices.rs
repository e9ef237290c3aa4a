//! Loops over the columns and the rows of a matrix, and over all elements of a bounded one.

use bessemer::prelude::*;

/// Norms of the columns and of all rows but one.
#[function]
pub fn norms(m: &Matrix3<f64>, n: &Matrix2x3<f32>) -> (f64, f32) {
    let (mut columns, mut rows) = (0.0, 0.0);
    for column in m.column_iter() {
        columns += column.norm();
    }
    for (i, row) in n.row_iter().enumerate() {
        if i == 1 && row[0] < 0.0 {
            continue;
        }
        rows += row.dot(&row) + row[2];
    }
    (columns, rows)
}

/// A matrix in a field, and names that the generated loop would use.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Held {
    gains: Matrix2x3<i32>,
}

#[data]
impl Held {
    /// The last column whose first element is above `column`.
    pub fn last_above(&self, column: i32) -> usize {
        let mut found = 9;
        for (row, line) in self.gains.column_iter().enumerate() {
            if line[0] > column {
                found = row;
            }
        }
        found
    }
}

/// Changes all elements until one is negative; an 8 continues the outer loop.
#[function]
pub fn changed(m: &mut BoundedMatrix<i32, 3, 4>, times: u8) -> i32 {
    let mut last = 0;
    'outer: for k in 0..i32::from(times % 4) {
        for value in m.iter_mut() {
            if *value < 0 {
                break 'outer;
            }
            if *value == 8 {
                continue 'outer;
            }
            if *value == 9 {
                break;
            }
            *value = value.wrapping_add(k);
            last = *value;
        }
        last += 1;
    }
    last
}

/// Folds and searches over all elements.
#[function]
pub fn folded(m: &BoundedMatrix<i32, 3, 4>) -> (i32, bool, usize, Option<i32>) {
    let sum = m.iter().fold(0i32, |sum, value| sum.wrapping_add(*value));
    let odd = m.iter().any(|value| value % 2 == 1);
    let positive = m.iter().filter(|value| **value > 0).count();
    (sum, odd, positive, m.iter().copied().max())
}

/// A name bound in one condition is used in the next.
#[function]
pub fn lent(flag: bool, x: Option<i32>) -> i32 {
    if let mut kept = flag
        && let item = &mut kept
    {
        *item = !*item;
        return i32::from(kept);
    }
    if let Some(value) = x
        && let value = value.wrapping_mul(3)
        && value > 10
    {
        return value;
    }
    0
}

/// Reversed and enumerated columns, also in a chain.
#[function]
pub fn counted(m: &mut Matrix3x4<f64>, w: &[f64; 4]) -> f64 {
    for (i, mut column) in m.column_iter_mut().enumerate() {
        column.scale_mut(w[i]);
        column[0] += i as f64;
    }
    let mut most = 0.0_f64;
    for column in m.column_iter().rev() {
        most = most.max(column.norm()) * 0.5;
    }
    if m.column_iter().enumerate().all(|(i, column)| column.norm() < w[i]) {
        return most;
    }
    let rows = m.row_iter().enumerate().fold(most, |sum, (i, row)| sum + row[0] * w[i]);
    rows + m.column_iter().rev().map(|column| column.sum()).fold(0.0, |a, b| a * 0.5 + b)
}
