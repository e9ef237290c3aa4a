//! Elimination with row pivots, in place, in nalgebra's order for each element.
//!
//! The pivot is the first of the largest magnitudes of its column. A multiplier is an element times the reciprocal of
//! the pivot, and an element undergoes the steps `(−u) · l + element` in ascending order.

use nalgebra::SMatrix;

use crate::math::Real;

/// Solves `a x = b` for each column of `b`, in place, with the bits of nalgebra's `a.lu().solve(&b)`.
///
/// `a` becomes its factors as nalgebra packs them (U, and L without its ones below), `b` becomes `x`,
/// and the result is `true`. If `a` is singular (a pivot is exactly zero), the result is `false` and
/// every element of both is NaN.
///
/// ```
/// use bessemer::prelude::*;
///
/// let mut a = Matrix2::new(2.0, 1.0, 1.0, 3.0);
/// let mut b = Vector2::new(3.0, 5.0);
/// assert!(bessemer::solve_mut(&mut a, &mut b));
/// assert_eq!(b, Vector2::new(0.8, 1.4));
/// ```
pub fn solve_mut<T: Real, const N: usize, const K: usize>(
    a: &mut SMatrix<T, N, N>,
    b: &mut SMatrix<T, N, K>,
) -> bool {
    for k in 0..N {
        let Some(pivot) = pivot(a, k) else {
            a.fill(T::NAN);
            b.fill(T::NAN);
            return false;
        };
        if pivot != k {
            a.swap_rows(k, pivot);
            b.swap_rows(k, pivot);
        }
        eliminate(a, k);
        forward(a, b, k);
    }
    backward(a, b);
    true
}

/// Solves `a x = b` for each column of `b`, in place of `b`, with the bits of nalgebra's `a.lu().solve(&b)`; `a`
/// stays as it is.
///
/// If `a` is singular (a pivot is exactly zero), the result is `false` and every element of `b` is NaN.
///
/// ```
/// use bessemer::prelude::*;
///
/// let a = Matrix2::new(2.0, 1.0, 1.0, 3.0);
/// let mut b = Vector2::new(3.0, 5.0);
/// assert!(bessemer::solve_into(&a, &mut b));
/// assert_eq!(b, Vector2::new(0.8, 1.4));
/// ```
///
/// Natively a copy of `a` lies on the stack; in the C there is none where it is large.
pub fn solve_into<T: Real, const N: usize, const K: usize>(
    a: &SMatrix<T, N, N>,
    b: &mut SMatrix<T, N, K>,
) -> bool {
    let mut factors = *a;
    solve_mut(&mut factors, b)
}

/// Inverts `a` in place, with the bits of nalgebra's `a.try_inverse()`: up to four rows by cofactors,
/// above by elimination.
///
/// If `a` is singular (its determinant, or a pivot, is exactly zero), the result is `false` and `a` is
/// as it was.
///
/// ```
/// use bessemer::prelude::*;
///
/// let mut a = Matrix2::new(2.0, 0.0, 0.0, 4.0);
/// assert!(bessemer::inverse_mut(&mut a));
/// assert_eq!(a, Matrix2::new(0.5, 0.0, 0.0, 0.25));
/// ```
///
/// Natively a copy of `a` lies on the stack.
pub fn inverse_mut<T: Real, const N: usize>(a: &mut SMatrix<T, N, N>) -> bool {
    if N <= 4 {
        return a.try_inverse_mut();
    }
    let mut factors = *a;
    let mut pivots = [0; N];
    for (k, chosen) in pivots.iter_mut().enumerate() {
        let Some(pivot) = pivot(&factors, k) else { return false };
        *chosen = pivot;
        if pivot != k {
            factors.swap_rows(k, pivot);
        }
        eliminate(&mut factors, k);
    }
    a.fill_with_identity();
    for (k, pivot) in pivots.into_iter().enumerate() {
        if pivot != k {
            a.swap_rows(k, pivot);
        }
    }
    for k in 0..N {
        forward(&factors, a, k);
    }
    backward(&factors, a);
    true
}

/// The determinant, with the bits of nalgebra's: up to three rows by minors, above by elimination.
pub(super) fn determinant<T: Real, const N: usize>(a: &SMatrix<T, N, N>) -> T {
    let minor =
        |one: usize, other: usize| a[(1, one)] * a[(2, other)] - a[(2, one)] * a[(1, other)];
    match N {
        1 => a[(0, 0)],
        2 => a[(0, 0)] * a[(1, 1)] - a[(1, 0)] * a[(0, 1)],
        3 => a[(0, 0)] * minor(1, 2) - a[(0, 1)] * minor(0, 2) + a[(0, 2)] * minor(0, 1),
        _ => by_elimination(a),
    }
}

fn by_elimination<T: Real, const N: usize>(a: &SMatrix<T, N, N>) -> T {
    let (mut factors, mut sign) = (*a, T::ONE);
    for k in 0..N {
        let Some(pivot) = pivot(&factors, k) else { continue };
        if pivot != k {
            factors.swap_rows(k, pivot);
            sign = -sign;
        }
        eliminate(&mut factors, k);
    }
    let product = (0..N).fold(T::ONE, |product, k| product * factors[(k, k)]);
    product * sign
}

/// Carrier of the companion of [`solve_mut`].
#[doc(hidden)]
#[allow(non_camel_case_types)]
pub struct solve_mut {}

/// Carrier of the companion of [`solve_into`].
#[doc(hidden)]
#[allow(non_camel_case_types)]
pub struct solve_into {}

/// Carrier of the companion of [`inverse_mut`].
#[doc(hidden)]
#[allow(non_camel_case_types)]
pub struct inverse_mut {}

/// Returns the row of the pivot of step `k`; none if the column is zero.
fn pivot<T: Real, const N: usize>(a: &SMatrix<T, N, N>, k: usize) -> Option<usize> {
    let mut pivot = k;
    for row in k + 1..N {
        if a[(row, k)].dsl_abs() > a[(pivot, k)].dsl_abs() {
            pivot = row;
        }
    }
    (a[(pivot, k)] != T::ZERO).then_some(pivot)
}

/// Subtracts multiples of row `k` from the rows below.
fn eliminate<T: Real, const N: usize>(a: &mut SMatrix<T, N, N>, k: usize) {
    let reciprocal = T::ONE / a[(k, k)];
    for row in k + 1..N {
        a[(row, k)] *= reciprocal;
    }
    for column in k + 1..N {
        let factor = -a[(k, column)];
        for row in k + 1..N {
            a[(row, column)] = factor * a[(row, k)] + a[(row, column)];
        }
    }
}

/// Subtracts the known values of step `k` from the rows of `b` below.
fn forward<T: Real, const N: usize, const K: usize>(
    a: &SMatrix<T, N, N>,
    b: &mut SMatrix<T, N, K>,
    k: usize,
) {
    for column in 0..K {
        let factor = -b[(k, column)];
        for row in k + 1..N {
            b[(row, column)] = factor * a[(row, k)] + b[(row, column)];
        }
    }
}

/// Solves by U, from the last row upwards.
fn backward<T: Real, const N: usize, const K: usize>(
    a: &SMatrix<T, N, N>,
    b: &mut SMatrix<T, N, K>,
) {
    for column in 0..K {
        for k in (0..N).rev() {
            let value = b[(k, column)] / a[(k, k)];
            b[(k, column)] = value;
            for row in 0..k {
                b[(row, column)] = -value * a[(row, k)] + b[(row, column)];
            }
        }
    }
}
