//! Matrices with a run-time size, up to a largest number of rows and of columns.
//!
//! They are written in the DSL, so the C follows from the Rust that the simulation runs. A size or an index that is
//! too large is a panic, and a fault in the C. Elements beyond the size are zero. Their arithmetic is in
//! `bounded_arithmetic`.

// The checks of indices are proved of loops over them.
#![allow(clippy::manual_memcpy, clippy::needless_range_loop)]

use core::ops::{Index, IndexMut};

use nalgebra::SMatrix;

use crate::element::Element;
use crate::{List, data};

/// A matrix of at most `R` rows and `C` columns; a dimension that never changes is one that is never resized.
///
/// ```
/// use bessemer::BoundedMatrix;
/// let mut m: BoundedMatrix<f64, 3, 5> = BoundedMatrix::new(2, 2);
/// m[(0, 1)] = 1.5;
/// m.resize(3, 2, 4.0);
/// assert_eq!((m.nrows(), m.ncols(), m[(0, 1)], m[(2, 0)]), (3, 2, 1.5, 4.0));
/// ```
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoundedMatrix<T, const R: usize, const C: usize> {
    /// Number of rows.
    pub(crate) rows: usize,
    /// Number of columns.
    pub(crate) columns: usize,
    /// The elements, column by column; zero beyond the size.
    pub(crate) elements: [[T; R]; C],
}

#[data]
impl<T: Element, const R: usize, const C: usize> BoundedMatrix<T, R, C> {
    /// Returns a matrix of zeros
    ///
    /// # Panics
    /// If there is no room for so many rows or columns.
    pub const fn new(rows: usize, columns: usize) -> Self {
        crate::__room!(rows <= R && columns <= C);
        BoundedMatrix { rows, columns, elements: [[T::ZERO; R]; C] }
    }

    /// Returns the number of rows.
    pub fn nrows(&self) -> usize {
        self.rows.min(R)
    }

    /// Returns the number of columns.
    pub fn ncols(&self) -> usize {
        self.columns.min(C)
    }

    /// Changes the size: elements within both sizes are kept, new ones are `value`
    ///
    /// # Panics
    /// If there is no room for so many rows or columns.
    pub fn resize(&mut self, rows: usize, columns: usize, value: T) {
        crate::__room!(rows <= R && columns <= C);
        for column in 0..C {
            for row in 0..R {
                let known = row < self.rows && column < self.columns;
                if row >= rows || column >= columns {
                    self.elements[column][row] = T::ZERO;
                } else if !known {
                    self.elements[column][row] = value;
                }
            }
        }
        self.rows = rows;
        self.columns = columns;
    }

    /// Sets every element to `value`.
    pub fn fill(&mut self, value: T) {
        for column in 0..self.columns.min(C) {
            for row in 0..self.rows.min(R) {
                self.elements[column][row] = value;
            }
        }
    }

    /// Returns the transpose.
    pub fn transpose(&self) -> BoundedMatrix<T, C, R> {
        let mut transposed =
            BoundedMatrix { rows: self.columns, columns: self.rows, elements: [[T::ZERO; C]; R] };
        for column in 0..self.columns.min(C) {
            for row in 0..self.rows.min(R) {
                transposed.elements[row][column] = self.elements[column][row];
            }
        }
        transposed
    }

    /// Returns a row as a list
    ///
    /// # Panics
    /// If there is no such row.
    pub fn row(&self, row: usize) -> List<T, C> {
        crate::__inside!(row < self.rows.min(R));
        let mut elements = List::new();
        for column in 0..self.columns.min(C) {
            elements.push(self.elements[column][row]);
        }
        elements
    }

    /// Returns a column as a list
    ///
    /// # Panics
    /// If there is no such column.
    pub fn column(&self, column: usize) -> List<T, R> {
        crate::__inside!(column < self.columns.min(C));
        let mut elements = List::new();
        for row in 0..self.rows.min(R) {
            elements.push(self.elements[column][row]);
        }
        elements
    }

    /// Returns a bounded matrix with the elements of a fixed one that fits.
    pub fn from_matrix<const ROWS: usize, const COLUMNS: usize>(
        matrix: &SMatrix<T, ROWS, COLUMNS>,
    ) -> Self {
        crate::__room!(ROWS <= R && COLUMNS <= C);
        let mut all = BoundedMatrix { rows: ROWS, columns: COLUMNS, elements: [[T::ZERO; R]; C] };
        for column in 0..COLUMNS {
            for row in 0..ROWS {
                all.elements[column][row] = matrix[(row, column)];
            }
        }
        all
    }

    /// Returns a matrix of a fixed size; none if the size differs.
    pub fn to_matrix<const ROWS: usize, const COLUMNS: usize>(
        &self,
    ) -> Option<SMatrix<T, ROWS, COLUMNS>> {
        if self.rows != ROWS || self.columns != COLUMNS || ROWS > R || COLUMNS > C {
            return None;
        }
        let mut matrix = SMatrix::<T, ROWS, COLUMNS>::repeat(T::ZERO);
        for column in 0..COLUMNS {
            for row in 0..ROWS {
                matrix[(row, column)] = self.elements[column][row];
            }
        }
        Some(matrix)
    }

    /// Returns the number of elements.
    pub fn len(&self) -> usize {
        self.rows.min(R) * self.columns.min(C)
    }

    /// Returns true if there are no elements.
    pub fn is_empty(&self) -> bool {
        self.rows == 0 || self.columns == 0
    }

    /// Removes all rows and columns.
    pub fn clear(&mut self) {
        self.elements = [[T::ZERO; R]; C];
        self.rows = 0;
        self.columns = 0;
    }

    /// Appends a column.
    ///
    /// # Panics
    ///
    /// If there is no room, or if its length is not the number of rows.
    pub fn push_column(&mut self, column: &[T]) {
        crate::__room!(self.columns < C && self.rows <= R);
        assert!(column.len() == self.rows, "the sizes differ");
        for row in 0..self.rows.min(R) {
            self.elements[self.columns][row] = column[row];
        }
        self.columns += 1;
    }

    /// Appends a row.
    ///
    /// # Panics
    ///
    /// If there is no room, or if its length is not the number of columns.
    pub fn push_row(&mut self, row: &[T]) {
        crate::__room!(self.rows < R && self.columns <= C);
        assert!(row.len() == self.columns, "the sizes differ");
        for column in 0..self.columns.min(C) {
            self.elements[column][self.rows] = row[column];
        }
        self.rows += 1;
    }

    /// Removes and returns the last column; none if there is none.
    pub fn pop_column(&mut self) -> Option<List<T, R>> {
        if self.columns == 0 || self.columns > C {
            return None;
        }
        let last = self.columns - 1;
        let mut column = List::new();
        for row in 0..self.rows.min(R) {
            column.push(self.elements[last][row]);
        }
        self.elements[last] = [T::ZERO; R];
        self.columns = last;
        Some(column)
    }

    /// Removes and returns the last row; none if there is none.
    pub fn pop_row(&mut self) -> Option<List<T, C>> {
        if self.rows == 0 || self.rows > R {
            return None;
        }
        let last = self.rows - 1;
        let mut row = List::new();
        for column in 0..self.columns.min(C) {
            row.push(self.elements[column][last]);
            self.elements[column][last] = T::ZERO;
        }
        self.rows = last;
        Some(row)
    }

    /// Returns the part of `rows` rows and `columns` columns that begins at a row and a column.
    ///
    /// # Panics
    ///
    /// If it exceeds the matrix.
    pub fn view(&self, row: usize, column: usize, rows: usize, columns: usize) -> Self {
        crate::__inside!(self.rows <= R && self.columns <= C);
        crate::__inside!(row <= self.rows && rows <= self.rows - row);
        crate::__inside!(column <= self.columns && columns <= self.columns - column);
        let mut part = BoundedMatrix { rows, columns, elements: [[T::ZERO; R]; C] };
        for j in 0..columns {
            for i in 0..rows {
                part.elements[j][i] = self.elements[column + j][row + i];
            }
        }
        part
    }
}

impl<T, const R: usize, const C: usize> BoundedMatrix<T, R, C> {
    /// Iterates over all elements, column by column. In the C these are loops.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = &T> {
        let (rows, columns) = (self.rows.min(R), self.columns.min(C));
        self.elements[..columns].iter().flat_map(move |column| &column[..rows])
    }

    /// Iterates over all elements mutably, column by column. In the C these are loops.
    pub fn iter_mut(&mut self) -> impl DoubleEndedIterator<Item = &mut T> {
        let (rows, columns) = (self.rows.min(R), self.columns.min(C));
        self.elements[..columns].iter_mut().flat_map(move |column| &mut column[..rows])
    }
}

impl<T: Element, const R: usize, const C: usize> Default for BoundedMatrix<T, R, C> {
    fn default() -> Self {
        BoundedMatrix { rows: 0, columns: 0, elements: [[T::ZERO; R]; C] }
    }
}

impl<T, const R: usize, const C: usize> Index<(usize, usize)> for BoundedMatrix<T, R, C> {
    type Output = T;
    fn index(&self, (row, column): (usize, usize)) -> &T {
        crate::__inside!(self.rows <= R && self.columns <= C);
        crate::__inside!(row < self.rows && column < self.columns);
        &self.elements[column][row]
    }
}

impl<T, const R: usize, const C: usize> IndexMut<(usize, usize)> for BoundedMatrix<T, R, C> {
    fn index_mut(&mut self, (row, column): (usize, usize)) -> &mut T {
        crate::__inside!(self.rows <= R && self.columns <= C);
        crate::__inside!(row < self.rows && column < self.columns);
        &mut self.elements[column][row]
    }
}
