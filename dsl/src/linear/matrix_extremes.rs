//! The largest and smallest elements of matrices, and their positions. The functions compute in the order of
//! nalgebra's methods of these names and are written in the DSL for the C.
//!
//! Values are compared as in nalgebra: a NaN discards the elements before it, and is the result only if it is last. A
//! position is that of the first of equal elements; a NaN is found only if it is the first element.

use nalgebra::{SMatrix, SVector};

use crate::element::Number;
use crate::math::Real;
use crate::{function, library};

/// The larger of two; the second if they are unordered.
#[function]
#[inline]
pub fn upper<T: Number>(a: T, b: T) -> T {
    if a >= b { a } else { b }
}

/// The smaller of two; the second if they are unordered.
#[function]
#[inline]
pub fn lower<T: Number>(a: T, b: T) -> T {
    if a <= b { a } else { b }
}

#[library(NumberExtremeCompanions)]
impl<T: Number, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// The largest element.
    pub fn max(a: &Self) -> T {
        let mut largest = a[(0, 0)];
        for column in 0..C {
            for row in 0..R {
                largest = upper(largest, a[(row, column)]);
            }
        }
        largest
    }

    /// The smallest element.
    pub fn min(a: &Self) -> T {
        let mut smallest = a[(0, 0)];
        for column in 0..C {
            for row in 0..R {
                smallest = lower(smallest, a[(row, column)]);
            }
        }
        smallest
    }
}

#[library(ExtremeCompanions)]
impl<T: Real, const R: usize, const C: usize> SMatrix<T, R, C> {
    /// The row and the column of the largest magnitude.
    #[method(iamax_full, icamax_full)]
    pub fn iamax_full(a: &Self) -> (usize, usize) {
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

    /// The smaller and the larger element of each pair.
    pub fn inf_sup(a: &Self, b: &Self) -> (Self, Self) {
        (a.inf(b), a.sup(b))
    }
}

#[library(VectorExtremeCompanions)]
impl<T: Real, const N: usize> SVector<T, N> {
    /// Index and value of the largest element.
    pub fn argmax(v: &Self) -> (usize, T) {
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

    /// Index and value of the smallest element.
    pub fn argmin(v: &Self) -> (usize, T) {
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

    /// Index of the largest element.
    pub fn imax(v: &Self) -> usize {
        let (place, _) = argmax(v);
        place
    }

    /// Index of the smallest element.
    pub fn imin(v: &Self) -> usize {
        let (place, _) = argmin(v);
        place
    }

    /// Index of the largest magnitude.
    #[method(iamax, icamax)]
    pub fn iamax(v: &Self) -> usize {
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

    /// Index of the smallest magnitude.
    pub fn iamin(v: &Self) -> usize {
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
}

/// Returns true if no element is infinite or a NaN.
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
