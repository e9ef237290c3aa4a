//! Powers and the exponential of square matrices.

use nalgebra::SMatrix;

use super::norms::one_norm;
use super::solve_mut;
use crate::library;
use crate::math::{Real, real};

#[library(PowerCompanions)]
impl<T: Real, const N: usize> SMatrix<T, N, N> {
    /// The power of a square matrix, by squaring, in nalgebra's order.
    pub fn pow(a: &Self, exponent: u32) -> Self {
        let mut left = exponent;
        let mut power = *a;
        if left & 1 == 0 {
            power = SMatrix::<T, N, N>::identity();
        }
        // What is odd is in the power already.
        left = left / 2 * 2;
        let mut square = *a;
        for _ in 0..32 {
            if left & 1 == 1 {
                power *= square;
            }
            left /= 2;
            if left == 0 {
                break;
            }
            square *= square;
        }
        power
    }

    /// Raises `a` to a power: see [`pow`].
    pub fn pow_mut(a: &mut Self, exponent: u32) {
        *a = pow(a, exponent);
    }

    /// The exponential of a matrix by Padé's approximant of degree 7. The matrix is halved until its one-norm is
    /// below 0.95, and the result is squared as often (Higham 2005). NaN everywhere if an element is not finite.
    ///
    /// nalgebra's function exists only with std, and uses the platform's logarithms and powers. This one has its own
    /// order of operations.
    pub fn exp(a: &Self) -> Self {
        let norm = one_norm(a);
        if !norm.is_finite() {
            return SMatrix::<T, N, N>::from_element(T::NAN);
        }
        let limit: T = real(0.95);
        let half: T = real(0.5);
        let mut scale = T::ONE;
        let mut squarings = 0;
        for halvings in 0..1025 {
            if norm * scale < limit {
                squarings = halvings;
                break;
            }
            scale *= half;
        }

        let identity = SMatrix::<T, N, N>::identity();
        let x = a * scale;
        let x2 = x * x;
        let x4 = x2 * x2;
        let x6 = x4 * x2;
        let inner = x6 + x4.scale(real(1_512.0)) + x2.scale(real(277_200.0));
        let odd = x * (inner + identity.scale(real(8_648_640.0)));
        let inner = x6.scale(real(56.0)) + x4.scale(real(25_200.0)) + x2.scale(real(1_995_840.0));
        let even = inner + identity.scale(real(17_297_280.0));
        let mut divisor = even - odd;
        let mut power = even + odd;
        solve_mut(&mut divisor, &mut power);

        for _ in 0..squarings {
            power *= power;
        }
        power
    }
}
