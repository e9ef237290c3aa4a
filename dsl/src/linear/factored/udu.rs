//! U D Uᵀ of a symmetric matrix, the form in which Bierman's filters store a covariance.

use nalgebra::{SMatrix, SVector};

use crate::math::Real;
use crate::{data, function};

/// The factors of a symmetric matrix.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Udu<T: Real, const N: usize> {
    /// U, with ones on its diagonal.
    pub u: SMatrix<T, N, N>,
    /// The diagonal of D.
    pub d: SVector<T, N>,
}

/// Factors a symmetric matrix, of which only the upper triangle is read; none if an element of D is zero.
#[function]
pub fn factored<T: Real, const N: usize>(p: &SMatrix<T, N, N>) -> Option<Udu<T, N>> {
    let mut u = SMatrix::<T, N, N>::zeros();
    let mut d = SVector::<T, N>::zeros();
    d[N - 1] = p[(N - 1, N - 1)];
    if d[N - 1] == T::ZERO {
        return None;
    }
    let reciprocal = T::ONE / d[N - 1];
    for row in 0..N {
        u[(row, N - 1)] = reciprocal * p[(row, N - 1)];
    }
    for column in (0..N - 1).rev() {
        let mut taken = T::ZERO;
        for k in column + 1..N {
            taken += d[k] * (u[(column, k)] * u[(column, k)]);
        }
        d[column] = p[(column, column)] - taken;
        if d[column] == T::ZERO {
            return None;
        }
        for row in (0..column + 1).rev() {
            let mut taken = T::ZERO;
            for k in column + 1..N {
                taken += d[k] * u[(column, k)] * u[(row, k)];
            }
            u[(row, column)] = (p[(row, column)] - taken) / d[column];
        }
        u[(column, column)] = T::ONE;
    }
    Some(Udu { u, d })
}

#[data]
impl<T: Real, const N: usize> Udu<T, N> {
    /// D.
    pub fn d_matrix(&self) -> SMatrix<T, N, N> {
        SMatrix::<T, N, N>::from_diagonal(&self.d)
    }
}
