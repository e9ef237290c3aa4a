//! Singular values, by Jacobi rotations of columns.
//!
//! nalgebra's function uses the platform's angles and iterates without a bound. This one has its own order of
//! operations and at most 30 sweeps; matrices up to 20 columns need about ten.

use nalgebra::{SMatrix, SVector};

use super::eigen::{tangent, turn};
use crate::linear::matrix_extremes::all_finite;
use crate::math::{Real, real};
use crate::{data, function};

/// Singular values and vectors of a matrix with at most as many columns as rows.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Svd<T: Real, const R: usize, const C: usize> {
    /// Left singular vectors as columns, orthonormal; zero for a zero value.
    pub u: SMatrix<T, R, C>,
    /// Singular values in descending order.
    pub singular_values: SVector<T, C>,
    /// Right singular vectors as rows.
    pub v_t: SMatrix<T, C, C>,
}

/// The scalar product of two columns.
#[function]
pub fn dot_of_columns<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
    first: usize,
    second: usize,
) -> T {
    let first = first.min(C - 1);
    let second = second.min(C - 1);
    let mut sum = T::ZERO;
    for row in 0..R {
        sum += a[(row, first)] * a[(row, second)];
    }
    sum
}

/// Singular values and vectors of a matrix with at most as many columns as rows (for others use the transpose). NaN
/// if an element is not finite.
///
/// The error of a value is about the largest of them times the rounding unit of the type.
#[function]
pub fn jacobi<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> Svd<T, R, C> {
    assert!(C <= R, "take the transpose");
    let mut u = *a;
    let mut v = SMatrix::<T, C, C>::identity();
    let mut singular_values = SVector::<T, C>::zeros();
    let largest = a.amax();
    if !all_finite(a) {
        u.fill(T::NAN);
        v.fill(T::NAN);
        singular_values.fill(T::NAN);
        return Svd { u, singular_values, v_t: v };
    }
    // Squares neither overflow nor vanish.
    if largest > T::ZERO {
        u /= largest;
    }
    let rows: T = real(R as f64);
    let tolerance = T::EPSILON * rows;
    for _ in 0..30 {
        let mut turned = false;
        for first in 0..C {
            for second in first + 1..C {
                let x = dot_of_columns(&u, first, first);
                let y = dot_of_columns(&u, second, second);
                let between = dot_of_columns(&u, first, second);
                if between.abs() > tolerance * (x * y).sqrt() {
                    turned = true;
                    let tangent = tangent(x, y, between);
                    let cosine = T::ONE / (tangent * tangent + T::ONE).sqrt();
                    turn(&mut u, first, second, cosine, tangent * cosine);
                    turn(&mut v, first, second, cosine, tangent * cosine);
                }
            }
        }
        if !turned {
            break;
        }
    }
    for column in 0..C {
        let length = dot_of_columns(&u, column, column).sqrt();
        if length > T::ZERO {
            for row in 0..R {
                u[(row, column)] /= length;
            }
        }
        singular_values[column] = length * largest;
    }
    for place in 0..C {
        for k in place + 1..C {
            if singular_values[k] > singular_values[place] {
                let held = singular_values[k];
                singular_values[k] = singular_values[place];
                singular_values[place] = held;
                for row in 0..R {
                    let held = u[(row, k)];
                    u[(row, k)] = u[(row, place)];
                    u[(row, place)] = held;
                }
                for row in 0..C {
                    let held = v[(row, k)];
                    v[(row, k)] = v[(row, place)];
                    v[(row, place)] = held;
                }
            }
        }
    }
    Svd { u, singular_values, v_t: v.transpose() }
}

#[data]
impl<T: Real, const R: usize, const C: usize> Svd<T, R, C> {
    /// Number of singular values above `least`.
    pub fn rank(&self, least: T) -> usize {
        let mut rank = 0;
        for k in 0..C {
            if self.singular_values[k] > least {
                rank += 1;
            }
        }
        rank
    }

    /// The least-squares solution of smallest norm for each column of `b`; values up to `least` count as zero.
    pub fn solve<const K: usize>(&self, b: &SMatrix<T, R, K>, least: T) -> SMatrix<T, C, K> {
        let mut parts = self.u.tr_mul(b);
        for column in 0..K {
            for k in 0..C {
                let value = self.singular_values[k];
                parts[(k, column)] =
                    if value > least { parts[(k, column)] / value } else { T::ZERO };
            }
        }
        self.v_t.tr_mul(&parts)
    }

    /// The Moore–Penrose inverse; values up to `least` count as zero.
    pub fn pseudo_inverse(&self, least: T) -> SMatrix<T, C, R> {
        let mut parts = self.u.transpose();
        for column in 0..R {
            for k in 0..C {
                let value = self.singular_values[k];
                parts[(k, column)] =
                    if value > least { parts[(k, column)] / value } else { T::ZERO };
            }
        }
        self.v_t.tr_mul(&parts)
    }

    /// The ratio of the largest value to the smallest; infinite for a singular matrix.
    pub fn condition(&self) -> T {
        if self.singular_values[C - 1] == T::ZERO {
            return T::INFINITY;
        }
        self.singular_values[0] / self.singular_values[C - 1]
    }
}
