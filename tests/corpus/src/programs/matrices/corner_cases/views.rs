//! Views at any position, written in every way.

use core::ops::{AddAssign, MulAssign, SubAssign};

use bessemer::prelude::*;

#[function]
pub fn read(m: &SMatrix<f64, 3, 4>, row: usize, column: usize) -> f64 {
    let line = m.row(row);
    let other = m.row(1) * 2.0 + line;
    m.column(column).norm() + other.sum() + m.column(column)[1] + line[2]
}

#[function]
pub fn blocks(m: &Matrix4<f32>, row: usize, column: usize) -> f32 {
    let block = m.fixed_view::<2, 2>(row, column);
    let product = block * m.fixed_view::<2, 2>(0, 2);
    let rows = m.fixed_rows::<2>(row);
    let columns = m.fixed_columns::<3>(column);
    product[(0, 1)] + rows.sum() + columns[(3, 2)] + (rows.nrows() * 10 + columns.ncols()) as f32
}

#[function]
pub fn written(m: &mut Matrix4<f64>, row: usize, v: &Vector4<f64>) {
    m.set_column(1, v);
    m.row_mut(row).copy_from(&v.transpose());
    m.fixed_view_mut::<2, 2>(2, 2).copy_from(&Matrix2::new(1.0, 2.0, 3.0, 4.0));
    let corner = m.fixed_view::<2, 2>(2, 2).into_owned();
    m.fixed_view_mut::<2, 2>(0, 1).copy_from(&corner);
    m.column_mut(0).unscale_mut(3.0);
    m.column_mut(3).fill(0.5);
    m.fill_row(1, 0.25);
    if v[0] > 3.0 {
        let before = *m;
        m.fill(v[1]);
        m.copy_from(&(before * 2.0));
    }
}

#[function]
pub fn changed(m: &mut Matrix3<f64>, column: usize, by: &Vector3<f64>) {
    let mut view = *m;
    view.fill_diagonal(2.0);
    m.set_row(0, &view.row(2).into_owned());
    let mut column_of = m.column(column).into_owned();
    column_of += by;
    m.set_column(column, &column_of);
}

/// Methods of views with the names of those of scalars.
#[function]
pub fn magnitudes_of_parts(m: &Matrix3<f64>) -> [f64; 4] {
    let block = m.fixed_view::<2, 2>(1, 0);
    [m.row(0).abs().sum(), m.column(1).max(), m.row(2).min(), block.abs().sum()]
}

/// Assigns to named views, and to a view of a matrix in an array.
#[function]
pub fn assigned(m: &mut [Matrix3<f64>; 2], v: &Vector3<f64>, at: usize) {
    m[at].column_mut(at).add_assign(v);
    m[1].row_mut(0).mul_assign(v.x);
    m[0].fixed_rows_mut::<2>(1).neg_mut();
    m[0].sub_assign(v * v.transpose());
}
