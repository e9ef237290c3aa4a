//! LU with row pivots.

use nalgebra::SMatrix;

use crate::math::Real;
use crate::{data, function};

/// The factors of a matrix whose rows were exchanged.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Lu<T: Real, const N: usize> {
    /// U, and below the diagonal L without its ones.
    factors: SMatrix<T, N, N>,
    /// Row with which each row was exchanged, in order.
    pivots: [u32; N],
}

/// Factors a matrix by elimination. The pivot is the first of the largest magnitudes; if it is zero, the column is
/// unchanged.
#[function]
pub fn factored<T: Real, const N: usize>(a: &SMatrix<T, N, N>) -> Lu<T, N> {
    let mut factors = *a;
    let mut pivots = [0; N];
    for k in 0..N {
        let mut pivot = k;
        let mut largest = factors[(k, k)].abs();
        for row in k + 1..N {
            let magnitude = factors[(row, k)].abs();
            if magnitude > largest {
                largest = magnitude;
                pivot = row;
            }
        }
        pivot = pivot.min(N - 1);
        if factors[(pivot, k)] == T::ZERO {
            pivots[k] = k as u32;
            continue;
        }
        pivots[k] = pivot as u32;
        for column in 0..N {
            let held = factors[(k, column)];
            factors[(k, column)] = factors[(pivot, column)];
            factors[(pivot, column)] = held;
        }
        let reciprocal = T::ONE / factors[(k, k)];
        for row in k + 1..N {
            factors[(row, k)] *= reciprocal;
        }
        for column in k + 1..N {
            let factor = -factors[(k, column)];
            for row in k + 1..N {
                factors[(row, column)] = factor * factors[(row, k)] + factors[(row, column)];
            }
        }
    }
    Lu { factors, pivots }
}

#[data]
impl<T: Real, const N: usize> Lu<T, N> {
    /// Solves for each column of `b`, in place. Returns false for a singular matrix; `b` is then unusable.
    pub fn solve_mut<const K: usize>(&self, b: &mut SMatrix<T, N, K>) -> bool {
        for k in 0..N {
            let pivot = (self.pivots[k] as usize).min(N - 1);
            for column in 0..K {
                let held = b[(k, column)];
                b[(k, column)] = b[(pivot, column)];
                b[(pivot, column)] = held;
            }
        }
        for column in 0..K {
            for k in 0..N {
                let factor = -b[(k, column)];
                for row in k + 1..N {
                    b[(row, column)] = factor * self.factors[(row, k)] + b[(row, column)];
                }
            }
        }
        for column in 0..K {
            for k in (0..N).rev() {
                let diagonal = self.factors[(k, k)];
                if diagonal == T::ZERO {
                    return false;
                }
                let value = b[(k, column)] / diagonal;
                b[(k, column)] = value;
                for row in 0..k {
                    b[(row, column)] = -value * self.factors[(row, k)] + b[(row, column)];
                }
            }
        }
        true
    }

    /// The solution for each column of `b`; none for a singular matrix.
    pub fn solve<const K: usize>(&self, b: &SMatrix<T, N, K>) -> Option<SMatrix<T, N, K>> {
        let mut x = *b;
        if self.solve_mut(&mut x) { Some(x) } else { None }
    }

    /// The inverse; none for a singular matrix.
    pub fn try_inverse(&self) -> Option<SMatrix<T, N, N>> {
        let mut inverse = SMatrix::<T, N, N>::identity();
        if self.solve_mut(&mut inverse) { Some(inverse) } else { None }
    }

    /// Returns true if no pivot is zero.
    pub fn is_invertible(&self) -> bool {
        for k in 0..N {
            if self.factors[(k, k)] == T::ZERO {
                return false;
            }
        }
        true
    }

    /// The determinant.
    pub fn determinant(&self) -> T {
        let mut product = T::ONE;
        let mut sign = T::ONE;
        for k in 0..N {
            product *= self.factors[(k, k)];
            if self.pivots[k] != k as u32 {
                sign = -sign;
            }
        }
        product * sign
    }

    /// L.
    pub fn l(&self) -> SMatrix<T, N, N> {
        let mut l = SMatrix::<T, N, N>::identity();
        for column in 0..N {
            for row in column + 1..N {
                l[(row, column)] = self.factors[(row, column)];
            }
        }
        l
    }

    /// U.
    pub fn u(&self) -> SMatrix<T, N, N> {
        let mut u = SMatrix::<T, N, N>::zeros();
        for column in 0..N {
            for row in 0..column + 1 {
                u[(row, column)] = self.factors[(row, column)];
            }
        }
        u
    }
}
