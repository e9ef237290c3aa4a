//! The largest possible index: the end of a view overflows before it is compared with the size; an index does not.

use bessemer::prelude::*;

#[function]
pub fn filled(m: &mut SMatrix<f64, 3, 2>, i: usize, j: usize) {
    m.row_mut(i).fill(1.0);
    m.column_mut(usize::MAX - j).fill(2.0);
}

#[function]
pub fn filled_at_once(m: &mut SMatrix<f64, 3, 2>, i: usize, j: usize) {
    m.fill_row(i, 1.0);
    m.fill_column(usize::MAX - j, 2.0);
}

#[function]
pub fn copied(m: &mut SMatrix<f64, 3, 2>, i: usize, j: usize) {
    m.row_mut(usize::MAX - i).copy_from(&SMatrix::<f64, 1, 2>::new(3.0, 4.0));
    m.column_mut(j).scale_mut(2.0);
}

#[function]
pub fn read(m: &SMatrix<f64, 3, 2>, i: usize, j: usize) -> f64 {
    m.row(usize::MAX - i)[0] + m.column(usize::MAX - j)[1] + m.fixed_rows::<2>(usize::MAX - i)[0]
}

#[function]
pub fn part(values: &[f64; 4], from: usize, to: usize) -> f64 {
    let sum: f64 = values[from..=to].iter().sum();
    sum
}
