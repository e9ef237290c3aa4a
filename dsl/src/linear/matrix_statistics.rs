//! Sums, products, means and variances of matrices, of their rows and of their columns. The functions compute in the
//! order of nalgebra's methods of these names and are written in the DSL for the C.

use nalgebra::{SMatrix, SVector};

use crate::element::Number;
use crate::library;
use crate::math::{Real, real};

#[library(SumCompanions)]
impl<T: Number, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// The sum of all elements, by columns.
    pub fn sum(a: &Self) -> T {
        let mut sum = T::ZERO;
        for column in 0..C {
            for row in 0..R {
                sum += a[(row, column)];
            }
        }
        sum
    }

    /// The sum of each column, as a column.
    pub fn row_sum_tr(a: &Self) -> SVector<T, C> {
        let mut sums = SVector::<T, C>::from_element(T::ZERO);
        for column in 0..C {
            for row in 0..R {
                sums[column] += a[(row, column)];
            }
        }
        sums
    }

    /// The sum of each column, as a row.
    pub fn row_sum(a: &Self) -> SMatrix<T, 1, C> {
        row_sum_tr(a).transpose()
    }

    /// The sum of each row.
    pub fn column_sum(a: &Self) -> SVector<T, R> {
        let mut sums = SVector::<T, R>::from_element(T::ZERO);
        for column in 0..C {
            for row in 0..R {
                sums[row] += a[(row, column)];
            }
        }
        sums
    }
}

#[library(StatisticCompanions)]
impl<T: Real, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// The product of all elements, by columns.
    pub fn product(a: &Self) -> T {
        let mut product = T::ONE;
        for column in 0..C {
            for row in 0..R {
                product *= a[(row, column)];
            }
        }
        product
    }

    /// The mean of all elements.
    pub fn mean(a: &Self) -> T {
        let count: T = real((R * C) as f64);
        sum(a) / count
    }

    /// The mean of the squared deviations from the mean.
    pub fn variance(a: &Self) -> T {
        let count: T = real((R * C) as f64);
        let mean = mean(a);
        let mut squares = T::ZERO;
        for column in 0..C {
            for row in 0..R {
                let distance = a[(row, column)] - mean;
                squares += distance * distance;
            }
        }
        squares / count
    }

    /// The product of each column, as a column.
    pub fn row_product_tr(a: &Self) -> SVector<T, C> {
        let mut products = SVector::<T, C>::from_element(T::ONE);
        for column in 0..C {
            for row in 0..R {
                products[column] *= a[(row, column)];
            }
        }
        products
    }

    /// The product of each column, as a row.
    pub fn row_product(a: &Self) -> SMatrix<T, 1, C> {
        row_product_tr(a).transpose()
    }

    /// The product of each row.
    pub fn column_product(a: &Self) -> SVector<T, R> {
        let mut products = SVector::<T, R>::from_element(T::ONE);
        for column in 0..C {
            for row in 0..R {
                products[row] *= a[(row, column)];
            }
        }
        products
    }

    /// The mean of each column, as a column.
    pub fn row_mean_tr(a: &Self) -> SVector<T, C> {
        let count: T = real(R as f64);
        row_sum_tr(a) / count
    }

    /// The mean of each column, as a row.
    pub fn row_mean(a: &Self) -> SMatrix<T, 1, C> {
        row_mean_tr(a).transpose()
    }

    /// The mean of each row: the sum of its elements, each multiplied by the reciprocal of their number.
    pub fn column_mean(a: &Self) -> SVector<T, R> {
        let count: T = real(C as f64);
        let share = T::ONE / count;
        let mut means = SVector::<T, R>::zeros();
        for column in 0..C {
            for row in 0..R {
                means[row] = share * a[(row, column)] + means[row];
            }
        }
        means
    }

    /// The variance of each column, as a column.
    pub fn row_variance_tr(a: &Self) -> SVector<T, C> {
        let count: T = real(R as f64);
        let means = row_mean_tr(a);
        let mut squares = SVector::<T, C>::zeros();
        for column in 0..C {
            for row in 0..R {
                let distance = a[(row, column)] - means[column];
                squares[column] += distance * distance;
            }
        }
        squares / count
    }

    /// The variance of each column, as a row.
    pub fn row_variance(a: &Self) -> SMatrix<T, 1, C> {
        row_variance_tr(a).transpose()
    }

    /// The variance of each row: the mean of the squares minus the square of the mean.
    pub fn column_variance(a: &Self) -> SVector<T, R> {
        let count: T = real(C as f64);
        let share = T::ONE / count;
        let means = column_mean(a);
        let mut variances = SVector::<T, R>::zeros();
        for row in 0..R {
            variances[row] = -(means[row] * means[row]);
        }
        for column in 0..C {
            for row in 0..R {
                variances[row] += share * a[(row, column)] * a[(row, column)];
            }
        }
        variances
    }
}
