//! QR by Householder reflections.

use nalgebra::{SMatrix, SVector};

use crate::math::{Real, real};
use crate::{data, function};

/// The factors of a matrix with no more columns than rows.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Qr<T: Real, const R: usize, const C: usize> {
    /// R above the diagonal; on and below it the axis of each reflection.
    factors: SMatrix<T, R, C>,
    /// The diagonal of R, each element with the sign of its reflection.
    diagonal: SVector<T, C>,
}

/// Scalar product of an axis and a column, both from a row on. It is computed in eight lanes, then one by one, as
/// nalgebra multiplies parts of columns.
#[function]
pub fn dot_below<T: Real, const R: usize, const C: usize>(
    axis: &SVector<T, R>,
    b: &SMatrix<T, R, C>,
    column: usize,
    from: usize,
) -> T {
    let column = column.min(C - 1);
    let from = from.min(R);
    let rest = (from + (R - from) / 8 * 8).min(R);
    let mut lanes = [T::ZERO; 8];
    for row in from..rest {
        lanes[(row - from) % 8] += axis[row] * b[(row, column)];
    }
    let mut sum = T::ZERO;
    for lane in 0..4 {
        sum += lanes[lane] + lanes[lane + 4];
    }
    for row in rest..R {
        sum += axis[row] * b[(row, column)];
    }
    sum
}

/// Reflects the columns of `b` from one on, in the rows from one on, at a unit axis; multiplied by `sign`.
#[function]
pub fn reflect<T: Real, const R: usize, const C: usize>(
    b: &mut SMatrix<T, R, C>,
    axis: &SVector<T, R>,
    from_row: usize,
    from_column: usize,
    sign: T,
) {
    let minus_two: T = real(-2.0);
    let twice = sign * minus_two;
    for column in from_column..C {
        let factor = dot_below(axis, b, column, from_row) * twice;
        for row in from_row..R {
            b[(row, column)] = factor * axis[row] + sign * b[(row, column)];
        }
    }
}

/// Factors a matrix, column by column.
#[function]
pub fn factored<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> Qr<T, R, C> {
    let two: T = real(2.0);
    let mut factors = *a;
    let mut diagonal = SVector::<T, C>::zeros();
    for k in 0..C {
        let mut axis = SVector::<T, R>::zeros();
        for row in k..R {
            axis[row] = factors[(row, k)];
        }
        let squares = dot_below(&axis, &axis, 0, k);
        let norm = squares.sqrt();
        let first = axis[k];
        let (magnitude, signed) = if first >= T::ZERO { (first, norm) } else { (-first, -norm) };
        let square = (squares + magnitude * norm) * two;
        axis[k] = first + signed;
        diagonal[k] = signed;
        if square != T::ZERO {
            axis /= square.sqrt();
            let length = dot_below(&axis, &axis, 0, k).sqrt();
            axis /= length;
            diagonal[k] = -signed;
            reflect(&mut factors, &axis, k, k + 1, diagonal[k].signum());
        }
        for row in k..R {
            factors[(row, k)] = axis[row];
        }
    }
    Qr { factors, diagonal }
}

#[data]
impl<T: Real, const R: usize, const C: usize> Qr<T, R, C> {
    /// R.
    pub fn r(&self) -> SMatrix<T, C, C> {
        let mut r = SMatrix::<T, C, C>::zeros();
        for column in 0..C {
            for row in 0..column {
                r[(row, column)] = self.factors[(row, column)];
            }
            r[(column, column)] = self.diagonal[column].abs();
        }
        r
    }

    /// Q.
    pub fn q(&self) -> SMatrix<T, R, C> {
        let mut q = SMatrix::<T, R, C>::from_diagonal_element(T::ONE);
        for k in (0..C).rev() {
            let axis = self.axis(k);
            reflect(&mut q, &axis, k, k, self.diagonal[k].signum());
        }
        q
    }

    /// Multiplies by the transpose of Q, in place.
    pub fn q_tr_mul<const K: usize>(&self, b: &mut SMatrix<T, R, K>) {
        for k in 0..C {
            let axis = self.axis(k);
            reflect(b, &axis, k, 0, self.diagonal[k].signum());
        }
    }

    /// The axis of a reflection, zero above its row.
    pub fn axis(&self, k: usize) -> SVector<T, R> {
        let k = k.min(C - 1);
        let mut axis = SVector::<T, R>::zeros();
        for row in k..R {
            axis[row] = self.factors[(row, k)];
        }
        axis
    }
}

/// Solves for each column of `b`, in place. Returns false for a singular matrix; `b` is then unusable.
#[function]
pub fn solve_mut<T: Real, const N: usize, const K: usize>(
    qr: &Qr<T, N, N>,
    b: &mut SMatrix<T, N, K>,
) -> bool {
    qr.q_tr_mul(b);
    for column in 0..K {
        for k in (0..N).rev() {
            let diagonal = qr.diagonal[k].abs();
            if diagonal == T::ZERO {
                return false;
            }
            let value = b[(k, column)] / diagonal;
            b[(k, column)] = value;
            for row in 0..k {
                b[(row, column)] = -value * qr.factors[(row, k)] + b[(row, column)];
            }
        }
    }
    true
}

/// The solution for each column of `b`; none for a singular matrix.
#[function]
pub fn solve<T: Real, const N: usize, const K: usize>(
    qr: &Qr<T, N, N>,
    b: &SMatrix<T, N, K>,
) -> Option<SMatrix<T, N, K>> {
    let mut x = *b;
    if solve_mut(qr, &mut x) { Some(x) } else { None }
}

/// The inverse; none for a singular matrix.
#[function]
pub fn try_inverse<T: Real, const N: usize>(qr: &Qr<T, N, N>) -> Option<SMatrix<T, N, N>> {
    let mut inverse = SMatrix::<T, N, N>::identity();
    if solve_mut(qr, &mut inverse) { Some(inverse) } else { None }
}

/// Returns true if the diagonal of R has no zero.
#[function]
pub fn is_invertible<T: Real, const N: usize>(qr: &Qr<T, N, N>) -> bool {
    for k in 0..N {
        if qr.diagonal[k] == T::ZERO {
            return false;
        }
    }
    true
}
