//! Iterators over the columns and rows of a matrix, for reading and writing.

use bessemer::prelude::*;

/// Columns and rows enumerated, zipped, chained, and searched from the end.
#[function]
pub fn read(m: &Matrix3x4<f64>, w: &[f64; 4]) -> (f64, f64, f64, Option<usize>) {
    let far = m.column_iter().enumerate().skip(1).map(|(i, c)| c.norm() * w[i]).fold(0.0, f64::max);
    let zipped = m.column_iter().zip(w).map(|(c, w)| c.sum() * w).sum::<f64>();
    let both = m.row_iter().skip(1).chain(m.row_iter()).map(|row| row[0]).sum::<f64>();
    let found = m.column_iter().enumerate().rev().find(|(_, c)| c[0] > 1.0).map(|(i, _)| i);
    (far, zipped, both, found)
}

/// Writes columns until a condition holds.
#[function]
pub fn written(m: &mut Matrix3x4<f64>, w: &[f64; 4]) {
    for (mut column, w) in m.column_iter_mut().zip(w) {
        column *= *w;
        if column[0] > 5.0 {
            break;
        }
    }
    m.row_iter_mut().enumerate().for_each(|(i, mut row)| row[i] = 1.0);
    for (mut row, other) in m.row_iter_mut().zip([1.0, 2.0]) {
        row.fill(other);
    }
}

/// Index of the column with the greatest first element, and the norm of the least row.
#[function]
pub fn extremes(m: &Matrix3x4<f32>) -> (Option<usize>, Option<f32>) {
    let firsts = m.column_iter().map(|column| column[0]).enumerate();
    let norms = m.row_iter().map(|row| row.norm());
    let first = firsts.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i);
    (first, norms.min_by(f32::total_cmp))
}

/// Views under a second name, named while the matrix is written, and an early return.
#[function]
pub fn other_names(a: &mut Matrix4<f64>, b: &Vector4<f64>) -> Option<f64> {
    let mut first = a.column_mut(0);
    first += b;
    let mut other = first;
    other += b;
    let mut second = a.column_mut(1);
    if b.x > 0.0 {
        second += b;
    } else {
        a.fill(0.0);
    }
    let mut third = a.row_mut(2);
    if b.y > 0.0 {
        third[0] = Some(b.y).filter(|y| *y > 1.0)?;
        third.iter_mut().skip(1).for_each(|x| *x *= 0.5);
    }
    Some(b.z)
}

/// A view of a view, its elements in order, and a large view that a function reads and writes.
#[function]
pub fn parts_of_parts(m: &mut SMatrix<f64, 6, 6>, at: usize, by: f64) -> f64 {
    let mut block = m.fixed_view_mut::<3, 4>(1, at);
    let mut line = block.row_mut(1);
    line += SMatrix::<f64, 1, 4>::from_element(by);
    block.column_mut(at).fill(by);
    for (i, x) in block.iter_mut().enumerate() {
        *x -= i as f64;
        if *x > 1e3 {
            return by;
        }
    }
    block[7] = block[(2, 3)];
    let mut large = m.fixed_rows_mut::<5>(1);
    large *= 0.5;
    large.normalize_mut()
}
