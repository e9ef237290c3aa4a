//! Matrices whose size is known when they are used, with a largest number of rows and of columns.
//!
//! Written in the DSL itself, so that the C is made of the Rust that the simulation runs. What has no room,
//! and an index beyond the size, is a panic, as it is a fault in the C. Elements beyond the size are zero.
//! Their arithmetic is in `bounded_arithmetic`.

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
    /// Zeros.
    ///
    /// # Panics
    /// If there is no room for so many rows or columns.
    pub const fn new(rows: usize, columns: usize) -> Self {
        crate::__room!(rows <= R && columns <= C);
        BoundedMatrix { rows, columns, elements: [[T::ZERO; R]; C] }
    }

    /// Number of rows.
    pub fn nrows(&self) -> usize {
        self.rows.min(R)
    }

    /// Number of columns.
    pub fn ncols(&self) -> usize {
        self.columns.min(C)
    }

    /// Makes it a matrix of another size: what is in both keeps its place, what is new is `value`.
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

    /// Makes every element the same.
    pub fn fill(&mut self, value: T) {
        for column in 0..self.columns.min(C) {
            for row in 0..self.rows.min(R) {
                self.elements[column][row] = value;
            }
        }
    }

    /// Rows as columns.
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

    /// A row, its elements as a list.
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

    /// A column, its elements as a list.
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

    /// The elements of a matrix that fits.
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

    /// The elements as a matrix of a fixed size, if it has that.
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

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.rows.min(R) * self.columns.min(C)
    }

    /// Returns true if there are none.
    pub fn is_empty(&self) -> bool {
        self.rows == 0 || self.columns == 0
    }

    /// Takes every row and column off.
    pub fn clear(&mut self) {
        self.elements = [[T::ZERO; R]; C];
        self.rows = 0;
        self.columns = 0;
    }

    /// Adds a column at the end.
    ///
    /// # Panics
    /// If there is no room, or if it has not as many elements as there are rows.
    pub fn push_column(&mut self, column: &[T]) {
        crate::__room!(self.columns < C && self.rows <= R);
        assert!(column.len() == self.rows, "the sizes differ");
        for row in 0..self.rows.min(R) {
            self.elements[self.columns][row] = column[row];
        }
        self.columns += 1;
    }

    /// Adds a row at the end.
    ///
    /// # Panics
    /// If there is no room, or if it has not as many elements as there are columns.
    pub fn push_row(&mut self, row: &[T]) {
        crate::__room!(self.rows < R && self.columns <= C);
        assert!(row.len() == self.columns, "the sizes differ");
        for column in 0..self.columns.min(C) {
            self.elements[column][self.rows] = row[column];
        }
        self.rows += 1;
    }

    /// Takes the last column off, if there is one.
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

    /// Takes the last row off, if there is one.
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

    /// The part of `rows` rows and `columns` columns that begins at a row and a column.
    ///
    /// # Panics
    /// If it goes beyond the matrix.
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
    /// All elements, column by column. In the C these are loops.
    pub fn iter(&self) -> impl DoubleEndedIterator<Item = &T> {
        let (rows, columns) = (self.rows.min(R), self.columns.min(C));
        self.elements[..columns].iter().flat_map(move |column| &column[..rows])
    }

    /// All elements, to be changed, column by column. In the C these are loops.
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
