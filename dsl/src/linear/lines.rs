//! Iterators over the columns and rows of a matrix, as functions of the DSL that are inlined where they are iterated.
//! Each passes its items to `__each`.
//!
//! Must not know: the consumer of the items.

use nalgebra::{SMatrix, SVector};

use super::views;
use crate::element::Element;
use crate::function;

/// Lines of a matrix, which the C writes in place. Here they are copies, since the simulation runs nalgebra's
/// iterators.
pub trait Lines<T, const R: usize, const C: usize> {
    /// Returns a column.
    fn written_column(&mut self, column: usize) -> SVector<T, R>;
    /// Returns a row.
    fn written_row(&mut self, row: usize) -> SMatrix<T, 1, C>;
}

impl<T: Element, const R: usize, const C: usize> Lines<T, R, C> for SMatrix<T, R, C> {
    fn written_column(&mut self, column: usize) -> SVector<T, R> {
        self.column(column).into_owned()
    }
    fn written_row(&mut self, row: usize) -> SMatrix<T, 1, C> {
        self.row(row).into_owned()
    }
}

/// Iterates over the columns.
#[function(expand)]
pub fn column_iter<T: Element, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
    mut __each: impl FnMut(SVector<T, R>),
) {
    for column in 0..C {
        __each(views::column(a, column));
    }
}

/// Iterates over the rows.
#[function(expand)]
pub fn row_iter<T: Element, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
    mut __each: impl FnMut(SMatrix<T, 1, C>),
) {
    for row in 0..R {
        __each(views::row(a, row));
    }
}

/// Iterates over the columns, which may be written.
#[function(expand)]
pub fn column_iter_mut<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    mut __each: impl FnMut(SVector<T, R>),
) {
    for column in 0..C {
        __each(a.written_column(column));
    }
}

/// Iterates over the rows, which may be written.
#[function(expand)]
pub fn row_iter_mut<T: Element, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    mut __each: impl FnMut(SMatrix<T, 1, C>),
) {
    for row in 0..R {
        __each(a.written_row(row));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Matrix2x3;
    extern crate std;
    use std::vec::Vec;

    /// Returns the items passed on.
    fn handed<T>(through: impl FnOnce(&mut dyn FnMut(T))) -> Vec<T> {
        let mut all = Vec::new();
        through(&mut |item| all.push(item));
        all
    }

    #[test]
    fn each_gives_what_nalgebra_gives() {
        let mut a = Matrix2x3::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
        let columns: Vec<_> = a.column_iter().map(|it| it.into_owned()).collect();
        assert_eq!(handed(|each| column_iter(&a, each)), columns);
        assert_eq!(handed(|each| column_iter_mut(&mut a, each)), columns);
        let rows: Vec<_> = a.row_iter().map(|it| it.into_owned()).collect();
        assert_eq!(handed(|each| row_iter(&a, each)), rows);
        assert_eq!(handed(|each| row_iter_mut(&mut a, each)), rows);
    }
}
