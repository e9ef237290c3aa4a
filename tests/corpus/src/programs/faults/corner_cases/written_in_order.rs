//! The position of a view is checked before the value that is written to it is evaluated.

use bessemer::prelude::*;

#[function]
pub fn divided(a: i32, b: i32) -> SVector<f64, 3> {
    let quotient = f64::from(a / b);
    SVector::<f64, 3>::new(quotient, 2.0 * quotient, 1.0)
}

#[function]
pub fn column(m: &mut SMatrix<f64, 3, 2>, j: usize, a: i32, b: i32) {
    m.column_mut(j).copy_from(&divided(a, b));
}

#[function]
pub fn row(m: &mut SMatrix<f64, 2, 3>, i: usize, a: i32, b: i32) {
    m.row_mut(i).copy_from(&divided(a, b).transpose());
}

#[function]
pub fn filled(m: &mut SMatrix<f64, 3, 2>, j: usize, a: i32, b: i32) {
    m.column_mut(j).fill(f64::from(a / b));
    m.row_mut(j + 1).fill(f64::from(b / a));
}

#[function]
pub fn block(m: &mut SMatrix<f64, 5, 4>, i: usize, j: usize, a: i32, b: i32) {
    m.fixed_view_mut::<3, 1>(i, j).copy_from(&divided(a, b));
    m.fixed_rows_mut::<1>(i).fill(1.0);
}

#[function]
pub fn literal(m: &mut SMatrix<f64, 3, 2>, a: i32, b: i32) {
    m.column_mut(1).copy_from(&divided(a, b));
    m.fixed_columns_mut::<1>(0).copy_from(&divided(b, a));
}
