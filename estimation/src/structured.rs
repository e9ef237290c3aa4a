//! Matrices whose structure their type knows, so that products skip the zeros.

use bessemer::prelude::*;

use crate::Symmetric;

/// A diagonal matrix.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Diagonal<T: Real, const N: usize> {
    /// Elements of the diagonal.
    pub values: SVector<T, N>,
}

#[data]
impl<T: Real, const N: usize> Diagonal<T, N> {
    /// Returns the matrix with its zeros.
    pub fn matrix(&self) -> SMatrix<T, N, N> {
        let mut matrix = SMatrix::zeros();
        for n in 0..N {
            matrix[(n, n)] = self.values[n];
        }
        matrix
    }

    /// Returns the product with a matrix: its rows, each times an element.
    pub fn times<const M: usize>(&self, matrix: &SMatrix<T, N, M>) -> SMatrix<T, N, M> {
        let mut product = *matrix;
        for col in 0..M {
            for row in 0..N {
                product[(row, col)] = self.values[row] * matrix[(row, col)];
            }
        }
        product
    }

    /// Returns D P D of a symmetric matrix P.
    pub fn congruence(&self, matrix: &Symmetric<T, N>) -> Symmetric<T, N> {
        let mut product = *matrix;
        for row in 0..N {
            for col in 0..=row {
                let value = self.values[row] * matrix.elements[(row, col)] * self.values[col];
                product.elements[(row, col)] = value;
                product.elements[(col, row)] = value;
            }
        }
        product
    }
}

/// Rows of the identity of size `N`: a measurement of some elements of a state.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Selection<const M: usize, const N: usize> {
    /// Indices of the selected elements; one of `N` or more selects the last.
    pub indices: [usize; M],
}

#[data]
impl<const M: usize, const N: usize> Selection<M, N> {
    /// Returns the selected elements.
    pub fn of<T: Real>(&self, state: &SVector<T, N>) -> SVector<T, M> {
        let mut selected = SVector::zeros();
        for m in 0..M {
            selected[m] = state[self.indices[m].min(N - 1)];
        }
        selected
    }

    /// Returns H P Hᵀ: the rows and columns of the selected elements.
    pub fn within<T: Real>(&self, matrix: &Symmetric<T, N>) -> Symmetric<T, M> {
        let mut selected = Symmetric::diagonal(&SVector::zeros());
        for row in 0..M {
            for col in 0..=row {
                let mirrored =
                    matrix.elements[(self.indices[row].min(N - 1), self.indices[col].min(N - 1))];
                selected.elements[(row, col)] = mirrored;
                selected.elements[(col, row)] = mirrored;
            }
        }
        selected
    }

    /// Returns the matrix with its zeros and ones.
    pub fn matrix<T: Real>(&self) -> SMatrix<T, M, N> {
        let mut matrix = SMatrix::zeros();
        for m in 0..M {
            matrix[(m, self.indices[m].min(N - 1))] = T::ONE;
        }
        matrix
    }
}

/// An upper triangle.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UpperTriangular<T: Real, const N: usize> {
    /// Elements; those below the diagonal are never read.
    pub elements: SMatrix<T, N, N>,
}

#[data]
impl<T: Real, const N: usize> UpperTriangular<T, N> {
    /// Returns the matrix with its zeros.
    pub fn matrix(&self) -> SMatrix<T, N, N> {
        self.elements.upper_triangle()
    }

    /// Returns the product U v.
    pub fn times(&self, vector: &SVector<T, N>) -> SVector<T, N> {
        let mut product = SVector::zeros();
        for col in 0..N {
            for row in 0..=col {
                product[row] += self.elements[(row, col)] * vector[col];
            }
        }
        product
    }

    /// Returns U Uᵀ.
    pub fn square(&self) -> Symmetric<T, N> {
        let mut square = Symmetric::diagonal(&SVector::zeros());
        for row in 0..N {
            for col in 0..=row {
                let mut sum = T::ZERO;
                for k in row..N {
                    sum += self.elements[(row, k)] * self.elements[(col, k)];
                }
                square.elements[(row, col)] = sum;
                square.elements[(col, row)] = sum;
            }
        }
        square
    }

    /// Returns the solution x of U x = b; none if an element of the diagonal is zero.
    pub fn solve(&self, right: &SVector<T, N>) -> Option<SVector<T, N>> {
        self.elements.solve_upper_triangular(right)
    }
}
