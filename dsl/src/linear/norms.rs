//! Norms, distances and normalisation. The functions compute in the order of nalgebra's methods of these names and are
//! written in the DSL for the C.

use nalgebra::{SMatrix, SVector, Unit};

use super::kernels::determinant;
use super::matrix_extremes::upper;
use crate::math::{Real, real};
use crate::{function, library};

#[library(NormCompanions)]
impl<T: Real, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// The largest sum of magnitudes of a column.
    pub fn one_norm(a: &Self) -> T {
        let mut largest = T::ZERO;
        for column in 0..C {
            let mut sum = T::ZERO;
            for row in 0..R {
                sum += a[(row, column)].abs();
            }
            largest = upper(largest, sum);
        }
        largest
    }

    /// The p-th root of the sum of the magnitudes to the power `p`, by columns.
    pub fn lp_norm(a: &Self, p: i32) -> T {
        let mut sum = T::ZERO;
        for column in 0..C {
            for row in 0..R {
                sum += a[(row, column)].abs().powi(p);
            }
        }
        sum.powf(real(1.0 / f64::from(p)))
    }

    /// The root of the sum of the squared differences, by columns.
    pub fn metric_distance(a: &Self, b: &Self) -> T {
        let mut squares = T::ZERO;
        for column in 0..C {
            for row in 0..R {
                let difference = a[(row, column)] - b[(row, column)];
                squares += difference * difference;
            }
        }
        squares.sqrt()
    }

    /// The matrix divided by its norm.
    pub fn normalize(a: &Self) -> Self {
        let norm = a.norm();
        a / norm
    }

    /// Divides a matrix by its norm, which is the result.
    pub fn normalize_mut(a: &mut Self) -> T {
        let norm = a.norm();
        *a /= norm;
        norm
    }

    /// The matrix divided by its norm; none if the norm is at most `least`.
    pub fn try_normalize(a: &Self, least: T) -> Option<Self> {
        let norm = a.norm();
        if norm <= least { None } else { Some(a / norm) }
    }

    /// Divides a matrix by its norm and returns the norm; none, without a change, if it is at most `least`.
    pub fn try_normalize_mut(a: &mut Self, least: T) -> Option<T> {
        let norm = a.norm();
        if norm <= least {
            return None;
        }
        *a /= norm;
        Some(norm)
    }

    /// Scales a matrix to the norm `magnitude`.
    pub fn set_magnitude(a: &mut Self, magnitude: T) {
        let factor = magnitude / a.norm();
        *a *= factor;
    }

    /// Scales a matrix to the norm `magnitude`, if its norm is above `least`.
    pub fn try_set_magnitude(a: &mut Self, magnitude: T, least: T) {
        let norm = a.norm();
        if norm > least {
            let factor = magnitude / norm;
            *a *= factor;
        }
    }

    /// The matrix, scaled to the norm `most` if its norm is above that.
    pub fn cap_magnitude(a: &Self, most: T) -> Self {
        let norm = a.norm();
        if norm > most { a * (most / norm) } else { *a }
    }

    /// Returns true if the matrix is close to the identity: see [`is_near`].
    pub fn is_identity(a: &Self, tolerance: T) -> bool {
        for column in 0..C {
            for row in 0..R {
                let wanted = if row == column { T::ONE } else { T::ZERO };
                if !is_near(a[(row, column)], wanted, tolerance) {
                    return false;
                }
            }
        }
        true
    }

    /// Returns true if the columns are close to orthonormal: see [`is_near`].
    pub fn is_orthogonal(a: &Self, tolerance: T) -> bool {
        is_identity(&a.tr_mul(a), tolerance)
    }
}

/// The distance between two points, computed as in nalgebra: the norm of their difference.
#[function(expand)]
pub fn distance<T: Real, const N: usize>(p: &SVector<T, N>, q: &SVector<T, N>) -> T {
    (q - p).norm()
}

/// The square of the distance between two points.
#[function(expand)]
pub fn distance_squared<T: Real, const N: usize>(p: &SVector<T, N>, q: &SVector<T, N>) -> T {
    (q - p).norm_squared()
}

/// Returns true if two numbers differ by no more than `tolerance`, or by a part of 2⁻⁵² (in single precision 2⁻²³) of
/// the larger.
#[function]
pub fn is_near<T: Real>(a: T, b: T, tolerance: T) -> bool {
    if a == b {
        return true;
    }
    if a.is_infinite() || b.is_infinite() {
        return false;
    }
    let difference = (a - b).abs();
    if difference <= tolerance {
        return true;
    }
    let (first, second) = (a.abs(), b.abs());
    let largest = if second > first { second } else { first };
    difference <= largest * T::EPSILON
}

#[library(SquareNormCompanions)]
impl<T: Real, const N: usize> SMatrix<T, N, N> {
    /// Returns true if a matrix is close to a rotation: orthonormal columns, and a positive determinant.
    pub fn is_special_orthogonal(a: &Self, tolerance: T) -> bool {
        is_orthogonal(a, tolerance) && determinant(a) > T::ZERO
    }

    /// Returns true if a matrix has an inverse.
    pub fn is_invertible(a: &Self) -> bool {
        super::inverse(a).is_some()
    }
}

#[library(DirectionCompanions)]
impl<T: Real, const N: usize> Unit<SVector<T, N>> {
    /// `v / |v|`; none if |v| is at most `least`.
    #[method(try_new)]
    #[by_value(v)]
    pub fn try_direction(v: &SVector<T, N>, least: T) -> Option<Self> {
        let (direction, _) = try_direction_and_norm(v, least)?;
        Some(direction)
    }

    /// Direction of a vector and |v|; none if |v| is at most `least`.
    #[method(try_new_and_get)]
    #[by_value(v)]
    pub fn try_direction_and_norm(v: &SVector<T, N>, least: T) -> Option<(Self, T)> {
        let squared = v.norm_squared();
        if squared > least * least {
            let norm = squared.sqrt();
            Some((Unit::new_unchecked(v / norm), norm))
        } else {
            None
        }
    }
}
