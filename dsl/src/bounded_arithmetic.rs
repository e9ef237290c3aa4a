//! Sums and products of matrices with a run-time size.
//!
//! They are written in the DSL. Sizes that do not fit are a panic, and a fault in the C. A product adds the terms of
//! an element in ascending order, as a simple loop does.

// The checks of indices are proved of loops over them.
#![allow(clippy::needless_range_loop)]

use core::ops::{Add, AddAssign, Mul, MulAssign, Sub, SubAssign};

use nalgebra::SVector;

use crate::element::Number;
use crate::{BoundedMatrix, data};

#[data(more)]
impl<T: Number, const R: usize, const C: usize> BoundedMatrix<T, R, C> {
    /// The sum of all elements, column by column.
    ///
    /// ```
    /// use bessemer::BoundedMatrix;
    /// let mut m: BoundedMatrix<i32, 2, 4> = BoundedMatrix::new(2, 3);
    /// m.fill(7);
    /// let twice = m + m;
    /// assert_eq!((twice.sum(), (twice * 3).sum(), twice - m == m), (84, 252, true));
    /// ```
    pub fn sum(&self) -> T {
        let mut sum = T::ZERO;
        for column in 0..self.columns.min(C) {
            for row in 0..self.rows.min(R) {
                sum += self.elements[column][row];
            }
        }
        sum
    }
}

/// Adds element by element
///
/// # Panics
/// If the sizes differ.
#[data]
impl<T: Number, const R: usize, const C: usize> AddAssign for BoundedMatrix<T, R, C> {
    fn add_assign(&mut self, other: BoundedMatrix<T, R, C>) {
        assert!(self.rows == other.rows && self.columns == other.columns, "the sizes differ");
        for column in 0..self.columns.min(C) {
            for row in 0..self.rows.min(R) {
                self.elements[column][row] += other.elements[column][row];
            }
        }
    }
}

/// Subtracts element by element
///
/// # Panics
/// If the sizes differ.
#[data]
impl<T: Number, const R: usize, const C: usize> SubAssign for BoundedMatrix<T, R, C> {
    fn sub_assign(&mut self, other: BoundedMatrix<T, R, C>) {
        assert!(self.rows == other.rows && self.columns == other.columns, "the sizes differ");
        for column in 0..self.columns.min(C) {
            for row in 0..self.rows.min(R) {
                self.elements[column][row] -= other.elements[column][row];
            }
        }
    }
}

/// Multiplies each element by a factor.
#[data]
impl<T: Number, const R: usize, const C: usize> MulAssign<T> for BoundedMatrix<T, R, C> {
    fn mul_assign(&mut self, factor: T) {
        for column in 0..self.columns.min(C) {
            for row in 0..self.rows.min(R) {
                self.elements[column][row] *= factor;
            }
        }
    }
}

/// Returns the sum, element by element
///
/// # Panics
/// If the sizes differ.
#[data]
impl<T: Number, const R: usize, const C: usize> Add for BoundedMatrix<T, R, C> {
    type Output = BoundedMatrix<T, R, C>;

    fn add(self, other: BoundedMatrix<T, R, C>) -> BoundedMatrix<T, R, C> {
        let mut sum = self;
        sum += other;
        sum
    }
}

/// Returns the difference, element by element
///
/// # Panics
/// If the sizes differ.
#[data]
impl<T: Number, const R: usize, const C: usize> Sub for BoundedMatrix<T, R, C> {
    type Output = BoundedMatrix<T, R, C>;

    fn sub(self, other: BoundedMatrix<T, R, C>) -> BoundedMatrix<T, R, C> {
        let mut difference = self;
        difference -= other;
        difference
    }
}

/// Returns each element multiplied by a factor.
#[data]
impl<T: Number, const R: usize, const C: usize> Mul<T> for BoundedMatrix<T, R, C> {
    type Output = BoundedMatrix<T, R, C>;

    fn mul(self, factor: T) -> BoundedMatrix<T, R, C> {
        let mut scaled = self;
        scaled *= factor;
        scaled
    }
}

/// Returns the product with another matrix; the terms of each element are added in ascending order.
///
/// # Panics
///
/// If the other's number of rows is not this one's number of columns.
#[data]
impl<T: Number, const R: usize, const C: usize, const K: usize> Mul<BoundedMatrix<T, C, K>>
    for BoundedMatrix<T, R, C>
{
    type Output = BoundedMatrix<T, R, K>;

    fn mul(self, other: BoundedMatrix<T, C, K>) -> BoundedMatrix<T, R, K> {
        assert!(self.columns == other.rows, "the sizes do not fit");
        let mut product =
            BoundedMatrix { rows: self.rows, columns: other.columns, elements: [[T::ZERO; R]; K] };
        for column in 0..other.columns.min(K) {
            for inner in 0..self.columns.min(C) {
                let factor = other.elements[column][inner];
                for row in 0..self.rows.min(R) {
                    product.elements[column][row] += self.elements[inner][row] * factor;
                }
            }
        }
        product
    }
}

/// Returns the product with a vector of the largest length, of which only the first elements count, one for each
/// column.
#[data]
impl<T: Number, const R: usize, const C: usize> Mul<SVector<T, C>> for BoundedMatrix<T, R, C> {
    type Output = SVector<T, R>;

    fn mul(self, vector: SVector<T, C>) -> SVector<T, R> {
        let mut product = SVector::<T, R>::repeat(T::ZERO);
        for column in 0..self.columns.min(C) {
            for row in 0..self.rows.min(R) {
                product[row] += self.elements[column][row] * vector[column];
            }
        }
        product
    }
}
