//! Operators and conversions of a generic type: each instance has its own functions in the C, named after their
//! types.

use core::ops::{Add, AddAssign, Mul, Neg};

use bessemer::prelude::*;

/// A number with a real and an imaginary part.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Complex<T> {
    pub re: T,
    pub im: T,
}

#[data]
impl<T: Real> Add for Complex<T> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Complex { re: self.re + other.re, im: self.im + other.im }
    }
}

#[data]
impl<T: Real> AddAssign for Complex<T> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

#[data]
impl<T: Real> Mul for Complex<T> {
    type Output = Self;

    fn mul(self, other: Self) -> Self::Output {
        Complex {
            re: self.re * other.re - self.im * other.im,
            im: self.re * other.im + self.im * other.re,
        }
    }
}

#[data]
impl<T: Real> Mul<T> for Complex<T> {
    type Output = Complex<T>;

    fn mul(self, factor: T) -> Complex<T> {
        Complex { re: self.re * factor, im: self.im * factor }
    }
}

#[data]
impl<T: Real> Neg for Complex<T> {
    type Output = Complex<T>;

    fn neg(self) -> Complex<T> {
        Complex { re: -self.re, im: -self.im }
    }
}

#[data]
impl<T: Real> From<T> for Complex<T> {
    fn from(re: T) -> Complex<T> {
        Complex { re, im: T::ZERO }
    }
}

/// Evaluates a polynomial by Horner's rule, for any float.
#[function]
pub fn polynomial<T: Real, const N: usize>(coefficients: &[T; N], z: Complex<T>) -> Complex<T> {
    let mut sum = Complex::from(T::ZERO);
    for &coefficient in coefficients {
        sum = sum * z + Complex::from(coefficient);
    }
    sum
}

/// Uses it in double precision.
#[function]
pub fn response(re: f64, im: f64) -> Complex<f64> {
    let z = Complex { re, im };
    let mut sum = polynomial(&[1.0, -0.5, 0.25], z) * 2.0;
    sum += -z;
    sum
}

/// Uses it in single precision.
#[function]
pub fn single(z: Complex<f32>) -> Complex<f32> {
    polynomial(&[0.5, 2.0], z)
}
