//! Eigenvalues of symmetric matrices, by Jacobi rotations.
//!
//! nalgebra's function iterates without a bound. This one has its own order of operations and at most 30 sweeps;
//! matrices up to 20 rows need about ten.

use nalgebra::{SMatrix, SVector};

use crate::linear::matrix_extremes::all_finite;
use crate::math::{Real, real};
use crate::{data, function};

/// Eigenvalues and eigenvectors of a symmetric matrix.
#[data]
#[derive(Clone, Copy, Debug)]
pub struct Eigen<T: Real, const N: usize> {
    /// Eigenvectors as columns, orthonormal.
    pub eigenvectors: SMatrix<T, N, N>,
    /// Eigenvalues in ascending order.
    pub eigenvalues: SVector<T, N>,
}

/// Tangent of the angle of a rotation that makes the element between two diagonal elements zero.
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

/// Rotates two columns in their plane.
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

/// Rotates two rows and the same two columns, so that the element between them becomes zero.
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

/// Eigenvalues and eigenvectors of a symmetric matrix, of which only the lower triangle is read. NaN if an element is
/// not finite.
///
/// The error of a value is about the largest of them times the rounding unit of the type.
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
