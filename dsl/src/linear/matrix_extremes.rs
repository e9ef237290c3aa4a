//! The largest and smallest elements of matrices, and where they are: what nalgebra's methods of these
//! names compute, in its order, written in the DSL for the C.
//!
//! Values are compared as nalgebra compares them: a NaN hides what comes before it and shows only at the
//! end. Places are those of the first of equals; a NaN is never one, unless it comes first.

use nalgebra::{SMatrix, SVector};

use crate::element::Number;
use crate::function;
use crate::math::Real;

/// The larger of two; the second where they do not compare.
#[function]
#[inline]
pub fn upper<T: Number>(a: T, b: T) -> T {
    if a >= b { a } else { b }
}

/// The smaller of two; the second where they do not compare.
#[function]
#[inline]
pub fn lower<T: Number>(a: T, b: T) -> T {
    if a <= b { a } else { b }
}

/// The largest element.
#[function]
pub fn max<T: Number, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> T {
    let mut largest = a[(0, 0)];
    for column in 0..C {
        for row in 0..R {
            largest = upper(largest, a[(row, column)]);
        }
    }
    largest
}

/// The smallest element.
#[function]
pub fn min<T: Number, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> T {
    let mut smallest = a[(0, 0)];
    for column in 0..C {
        for row in 0..R {
            smallest = lower(smallest, a[(row, column)]);
        }
    }
    smallest
}

/// The largest magnitude.
#[function]
pub fn amax<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> T {
    let mut largest = a[(0, 0)].abs();
    for column in 0..C {
        for row in 0..R {
            largest = upper(largest, a[(row, column)].abs());
        }
    }
    largest
}

/// The smallest magnitude.
#[function]
pub fn amin<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> T {
    let mut smallest = a[(0, 0)].abs();
    for column in 0..C {
        for row in 0..R {
            smallest = lower(smallest, a[(row, column)].abs());
        }
    }
    smallest
}

/// Where the largest element is, and what it is.
#[function]
pub fn argmax<T: Real, const N: usize>(v: &SVector<T, N>) -> (usize, T) {
    let mut largest = v[0];
    let mut place = 0;
    for k in 1..N {
        if v[k] > largest {
            largest = v[k];
            place = k;
        }
    }
    (place, largest)
}

/// Where the smallest element is, and what it is.
#[function]
pub fn argmin<T: Real, const N: usize>(v: &SVector<T, N>) -> (usize, T) {
    let mut smallest = v[0];
    let mut place = 0;
    for k in 1..N {
        if v[k] < smallest {
            smallest = v[k];
            place = k;
        }
    }
    (place, smallest)
}

/// Where the largest element is.
#[function]
pub fn imax<T: Real, const N: usize>(v: &SVector<T, N>) -> usize {
    let (place, _) = argmax(v);
    place
}

/// Where the smallest element is.
#[function]
pub fn imin<T: Real, const N: usize>(v: &SVector<T, N>) -> usize {
    let (place, _) = argmin(v);
    place
}

/// Where the largest magnitude is.
#[function]
pub fn iamax<T: Real, const N: usize>(v: &SVector<T, N>) -> usize {
    let mut largest = v[0].abs();
    let mut place = 0;
    for k in 1..N {
        let magnitude = v[k].abs();
        if magnitude > largest {
            largest = magnitude;
            place = k;
        }
    }
    place
}

/// Where the smallest magnitude is.
#[function]
pub fn iamin<T: Real, const N: usize>(v: &SVector<T, N>) -> usize {
    let mut smallest = v[0].abs();
    let mut place = 0;
    for k in 1..N {
        let magnitude = v[k].abs();
        if magnitude < smallest {
            smallest = magnitude;
            place = k;
        }
    }
    place
}

/// The row and the column of the largest magnitude.
#[function]
pub fn iamax_full<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> (usize, usize) {
    let mut largest = a[(0, 0)].abs();
    let mut place = (0, 0);
    for column in 0..C {
        for row in 0..R {
            let magnitude = a[(row, column)].abs();
            if magnitude > largest {
                largest = magnitude;
                place = (row, column);
            }
        }
    }
    place
}

/// Whether no element is infinite or a NaN.
#[function]
pub fn all_finite<T: Real, const R: usize, const C: usize>(a: &SMatrix<T, R, C>) -> bool {
    for column in 0..C {
        for row in 0..R {
            if !a[(row, column)].is_finite() {
                return false;
            }
        }
    }
    true
}

/// Of each pair of elements the smaller.
#[function]
pub fn inf<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
    b: &SMatrix<T, R, C>,
) -> SMatrix<T, R, C> {
    let mut smaller = *a;
    for column in 0..C {
        for row in 0..R {
            smaller[(row, column)] = lower(a[(row, column)], b[(row, column)]);
        }
    }
    smaller
}

/// Of each pair of elements the larger.
#[function]
pub fn sup<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
    b: &SMatrix<T, R, C>,
) -> SMatrix<T, R, C> {
    let mut larger = *a;
    for column in 0..C {
        for row in 0..R {
            larger[(row, column)] = upper(a[(row, column)], b[(row, column)]);
        }
    }
    larger
}

/// Of each pair of elements the smaller, and the larger.
#[function]
pub fn inf_sup<T: Real, const R: usize, const C: usize>(
    a: &SMatrix<T, R, C>,
    b: &SMatrix<T, R, C>,
) -> (SMatrix<T, R, C>, SMatrix<T, R, C>) {
    (inf(a, b), sup(a, b))
}
