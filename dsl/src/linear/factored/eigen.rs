//! Eigenvalues of symmetric matrices, by Jacobi's rotations.
//!
//! nalgebra's own iterates without a bound; this has an order of its own and at most 30 sweeps, of which
//! matrices up to 20 rows take about ten.

use nalgebra::{SMatrix, SVector};

use crate::linear::matrix_extremes::all_finite;
use crate::math::{Real, real};
use crate::{data, function};

/// The eigenvalues of a symmetric matrix and their vectors.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Eigen<T: Real, const N: usize> {
    /// The vectors, of length 1 and at right angles, as columns.
    pub eigenvectors: SMatrix<T, N, N>,
    /// The values, the smallest first.
    pub eigenvalues: SVector<T, N>,
}

/// The angle of a rotation that makes the element between two of the diagonal zero: its tangent.
#[function]
pub fn tangent<T: Real>(first: T, second: T, between: T) -> T {
    let difference = second - first;
    if difference.abs() + between.abs() == difference.abs() {
        return between / difference;
    }
    let two: T = real(2.0);
    let ratio = difference / (two * between);
    let tangent = T::ONE / (ratio.abs() + (ratio * ratio + T::ONE).sqrt());
    if ratio < T::ZERO { -tangent } else { tangent }
}

/// Turns two columns against each other.
#[function]
pub fn turn<T: Real, const R: usize, const C: usize>(
    a: &mut SMatrix<T, R, C>,
    first: usize,
    second: usize,
    cosine: T,
    sine: T,
) {
    let first = first.min(C - 1);
    let second = second.min(C - 1);
    for row in 0..R {
        let (x, y) = (a[(row, first)], a[(row, second)]);
        a[(row, first)] = cosine * x - sine * y;
        a[(row, second)] = sine * x + cosine * y;
    }
}

/// Turns two rows and the same two columns, so that the element where they cross becomes zero.
#[function]
pub fn turn_both<T: Real, const N: usize>(
    a: &mut SMatrix<T, N, N>,
    first: usize,
    second: usize,
    tangent: T,
    cosine: T,
) {
    let first = first.min(N - 1);
    let second = second.min(N - 1);
    let sine = tangent * cosine;
    let moved = tangent * a[(first, second)];
    for k in 0..N {
        if k != first && k != second {
            let (x, y) = (a[(k, first)], a[(k, second)]);
            a[(k, first)] = cosine * x - sine * y;
            a[(k, second)] = sine * x + cosine * y;
            a[(first, k)] = a[(k, first)];
            a[(second, k)] = a[(k, second)];
        }
    }
    a[(first, first)] -= moved;
    a[(second, second)] += moved;
    a[(first, second)] = T::ZERO;
    a[(second, first)] = T::ZERO;
}

/// The eigenvalues of a symmetric matrix, of which the lower triangle is read, and their vectors. NaN
/// where an element is not finite.
///
/// An error of the values is about the largest of them times the rounding of the type.
#[function]
pub fn symmetric<T: Real, const N: usize>(a: &SMatrix<T, N, N>) -> Eigen<T, N> {
    let mut rest = *a;
    rest.fill_upper_triangle_with_lower_triangle();
    let mut eigenvectors = SMatrix::<T, N, N>::identity();
    let mut eigenvalues = SVector::<T, N>::zeros();
    if !all_finite(&rest) {
        eigenvectors.fill(T::NAN);
        eigenvalues.fill(T::NAN);
        return Eigen { eigenvectors, eigenvalues };
    }
    for _ in 0..30 {
        let mut turned = false;
        for first in 0..N {
            for second in first + 1..N {
                let between = rest[(second, first)].abs();
                let (x, y) = (rest[(first, first)].abs(), rest[(second, second)].abs());
                if x + between == x && y + between == y {
                    rest[(first, second)] = T::ZERO;
                    rest[(second, first)] = T::ZERO;
                } else {
                    turned = true;
                    let tangent = tangent(
                        rest[(first, first)],
                        rest[(second, second)],
                        rest[(second, first)],
                    );
                    let cosine = T::ONE / (tangent * tangent + T::ONE).sqrt();
                    turn_both(&mut rest, first, second, tangent, cosine);
                    turn(&mut eigenvectors, first, second, cosine, tangent * cosine);
                }
            }
        }
        if !turned {
            break;
        }
    }
    for k in 0..N {
        eigenvalues[k] = rest[(k, k)];
    }
    for place in 0..N {
        for k in place + 1..N {
            if eigenvalues[k] < eigenvalues[place] {
                let held = eigenvalues[k];
                eigenvalues[k] = eigenvalues[place];
                eigenvalues[place] = held;
                for row in 0..N {
                    let held = eigenvectors[(row, k)];
                    eigenvectors[(row, k)] = eigenvectors[(row, place)];
                    eigenvectors[(row, place)] = held;
                }
            }
        }
    }
    Eigen { eigenvectors, eigenvalues }
}
