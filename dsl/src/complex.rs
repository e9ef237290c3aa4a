//! Complex numbers: the functions of nalgebra's `Complex` in its order of operations, with the DSL's elementary
//! functions
//!
//! Without std nalgebra's type has neither an absolute value nor an argument, and with it they are the platform's. So the
//! attributes put these functions in place of its own: `z.exp()`, `z.arg()`, `Complex::from_polar(r, angle)`. The absolute
//! value alone is called by its path, since matrices have a `norm` of their own. Angles are in rad.
//!
//! ```
//! use bessemer::complex;
//! use bessemer::nalgebra::Complex;
//!
//! let z = Complex::new(3.0_f64, 4.0);
//! assert_eq!(complex::norm(&z), 5.0);
//! assert_eq!(complex::sqrt(&Complex::new(-4.0_f64, 0.0)), Complex::new(0.0, 2.0));
//! ```

use nalgebra::Complex as Native;

use crate::Plain;
use crate::library;
use crate::prelude::*;

/// A complex number re + im·𝐢.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ComplexNumber<T> {
    /// The real part.
    pub re: T,
    /// The imaginary part.
    pub im: T,
}

#[library(ComplexCompanions)]
impl<T: Real> Native<T> {
    /// The imaginary unit.
    pub fn i() -> Self {
        Native::new(T::ZERO, T::ONE)
    }

    /// Returns the complex number with an absolute value and an argument, rad.
    pub fn from_polar(r: T, angle: T) -> Self {
        let (sine, cosine) = angle.sin_cos();
        Native::new(r * cosine, r * sine)
    }

    /// Returns e to the power of `angle`·𝐢; `angle` in rad.
    pub fn cis(angle: T) -> Self {
        let (sine, cosine) = angle.sin_cos();
        Native::new(cosine, sine)
    }

    /// Multiplies each part by a real number.
    pub fn scale(z: &Self, factor: T) -> Self {
        Native::new(z.re * factor, z.im * factor)
    }

    /// Divides each part by a real number.
    pub fn unscale(z: &Self, divisor: T) -> Self {
        Native::new(z.re / divisor, z.im / divisor)
    }

    /// The conjugate.
    #[method(conj, conjugate)]
    pub fn conj(z: &Self) -> Self {
        Native::new(z.re, -z.im)
    }

    /// Returns the reciprocal.
    pub fn inv(z: &Self) -> Self {
        let squared = norm_sqr(z);
        Native::new(z.re / squared, -z.im / squared)
    }

    /// The square of the absolute value.
    #[method(norm_sqr, modulus_squared)]
    pub fn norm_sqr(z: &Self) -> T {
        z.re * z.re + z.im * z.im
    }

    /// The sum of the magnitudes of the parts.
    #[method(l1_norm, norm1)]
    pub fn l1_norm(z: &Self) -> T {
        z.re.abs() + z.im.abs()
    }

    /// The absolute value, as nalgebra's `ComplexField` calls it.
    #[method(abs, modulus)]
    #[by_value(z)]
    pub fn abs(z: &Self) -> T {
        norm(z)
    }

    /// The argument, rad, −π to π.
    #[method(arg, argument)]
    #[by_value(z)]
    pub fn arg(z: &Self) -> T {
        z.im.atan2(z.re)
    }

    /// The absolute value and the argument, rad.
    #[by_value(z)]
    pub fn to_polar(z: &Self) -> (T, T) {
        (norm(z), arg(z))
    }

    /// Returns true if a part is not a number.
    #[by_value(z)]
    pub fn is_nan(z: &Self) -> bool {
        z.re.is_nan() || z.im.is_nan()
    }

    /// Returns true if a part is infinite, and none is not a number.
    #[by_value(z)]
    pub fn is_infinite(z: &Self) -> bool {
        !is_nan(z) && (z.re.is_infinite() || z.im.is_infinite())
    }

    /// Returns true if both parts are finite.
    #[by_value(z)]
    pub fn is_finite(z: &Self) -> bool {
        z.re.is_finite() && z.im.is_finite()
    }

    /// Returns the power with a non-negative integer exponent, by squaring.
    pub fn powu(z: &Self, exponent: u32) -> Self {
        let mut result = Native::new(T::ONE, T::ZERO);
        let mut square = *z;
        let mut left = exponent;
        let mut begun = false;
        for _ in 0..32 {
            if left & 1 == 1 {
                result = if begun { product(&result, &square) } else { square };
                begun = true;
            }
            left >>= 1;
            if left == 0 {
                break;
            }
            square = product(&square, &square);
        }
        result
    }

    /// Returns the power with an integer exponent.
    pub fn powi(z: &Self, exponent: i32) -> Self {
        if exponent < 0 { powu(&inv(z), exponent.unsigned_abs()) } else { powu(z, exponent as u32) }
    }

    /// Returns the power with a real exponent.
    #[by_value(z)]
    pub fn powf(z: &Self, exponent: T) -> Self {
        if exponent == T::ZERO {
            return from_real(T::ONE);
        }
        let (r, angle) = to_polar(z);
        from_polar(r.powf(exponent), angle * exponent)
    }

    /// Returns e to the power of a complex number.
    #[by_value(z)]
    pub fn exp(z: &Self) -> Self {
        let (re, im) = (z.re, z.im);
        if re.is_infinite() {
            if re < T::ZERO {
                if !im.is_finite() {
                    return Native::new(T::ZERO, T::ZERO);
                }
            } else if im == T::ZERO || !im.is_finite() {
                return Native::new(re, if im.is_infinite() { T::NAN } else { im });
            }
        } else if re.is_nan() && im == T::ZERO {
            return *z;
        }
        from_polar(re.exp(), im)
    }

    /// The principal value of the natural logarithm.
    #[by_value(z)]
    pub fn ln(z: &Self) -> Self {
        let (r, angle) = to_polar(z);
        Native::new(r.ln(), angle)
    }

    /// The principal value of the square root.
    #[by_value(z)]
    pub fn sqrt(z: &Self) -> Self {
        if z.im == T::ZERO {
            if z.re.is_sign_positive() {
                return Native::new(z.re.sqrt(), z.im);
            }
            let root = (-z.re).sqrt();
            return Native::new(T::ZERO, if z.im.is_sign_positive() { root } else { -root });
        }
        if z.re == T::ZERO {
            let root = (z.im.abs() / real(2.0)).sqrt();
            return Native::new(root, if z.im.is_sign_positive() { root } else { -root });
        }
        let (r, angle) = to_polar(z);
        from_polar(r.sqrt(), angle / real(2.0))
    }

    /// The sine.
    #[by_value(z)]
    pub fn sin(z: &Self) -> Self {
        let (sine, cosine) = z.re.sin_cos();
        Native::new(sine * z.im.cosh(), cosine * z.im.sinh())
    }

    /// The cosine.
    #[by_value(z)]
    pub fn cos(z: &Self) -> Self {
        let (sine, cosine) = z.re.sin_cos();
        Native::new(cosine * z.im.cosh(), -sine * z.im.sinh())
    }

    /// The hyperbolic sine.
    #[by_value(z)]
    pub fn sinh(z: &Self) -> Self {
        let (sine, cosine) = z.im.sin_cos();
        Native::new(z.re.sinh() * cosine, z.re.cosh() * sine)
    }

    /// The hyperbolic cosine.
    #[by_value(z)]
    pub fn cosh(z: &Self) -> Self {
        let (sine, cosine) = z.im.sin_cos();
        Native::new(z.re.cosh() * cosine, z.re.sinh() * sine)
    }
}

/// A real number as a complex one.
#[function]
pub fn from_real<T: Real>(re: T) -> Native<T> {
    Native::new(re, T::ZERO)
}

/// The sum.
#[function]
pub fn sum<T: Real>(a: &Native<T>, b: &Native<T>) -> Native<T> {
    Native::new(a.re + b.re, a.im + b.im)
}

/// The sum with a real number.
#[function]
pub fn sum_with_real<T: Real>(a: &Native<T>, b: T) -> Native<T> {
    Native::new(a.re + b, a.im)
}

/// Sum of a real and a complex number.
#[function]
pub fn sum_of_real<T: Real>(a: T, b: &Native<T>) -> Native<T> {
    Native::new(a + b.re, b.im)
}

/// The difference.
#[function]
pub fn difference<T: Real>(a: &Native<T>, b: &Native<T>) -> Native<T> {
    Native::new(a.re - b.re, a.im - b.im)
}

/// The difference from a real number.
#[function]
pub fn difference_with_real<T: Real>(a: &Native<T>, b: T) -> Native<T> {
    Native::new(a.re - b, a.im)
}

/// Difference of a real and a complex number.
#[function]
pub fn difference_of_real<T: Real>(a: T, b: &Native<T>) -> Native<T> {
    Native::new(a - b.re, T::ZERO - b.im)
}

/// The product.
#[function]
pub fn product<T: Real>(a: &Native<T>, b: &Native<T>) -> Native<T> {
    Native::new(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re)
}

/// Product of a real and a complex number.
#[function]
pub fn scaled_by<T: Real>(factor: T, z: &Native<T>) -> Native<T> {
    Native::new(factor * z.re, factor * z.im)
}

/// The quotient.
#[function]
pub fn quotient<T: Real>(a: &Native<T>, b: &Native<T>) -> Native<T> {
    let squared = norm_sqr(b);
    let re = a.re * b.re + a.im * b.im;
    let im = a.im * b.re - a.re * b.im;
    Native::new(re / squared, im / squared)
}

/// The quotient of a real and a complex number.
#[function]
pub fn quotient_of_real<T: Real>(a: T, b: &Native<T>) -> Native<T> {
    let squared = norm_sqr(b);
    Native::new(a * b.re / squared, T::ZERO - a * b.im / squared)
}

/// The negation.
#[function]
pub fn negative<T: Real>(z: &Native<T>) -> Native<T> {
    Native::new(-z.re, -z.im)
}

/// The absolute value, without overflow in intermediate results.
#[function]
pub fn norm<T: Real>(z: &Native<T>) -> T {
    z.re.hypot(z.im)
}

/// The attributes call these in place of the methods of these names.
#[doc(hidden)]
pub trait ComplexMethods<T>: Sized {
    /// Calls [`from_polar`].
    fn dsl_from_polar(r: T, angle: T) -> Self;
    /// Calls [`cis`].
    fn dsl_cis(angle: T) -> Self;
    /// Calls [`abs`].
    fn dsl_abs(self) -> T;
    /// Calls [`arg`].
    fn dsl_arg(self) -> T;
    /// [`abs`], by its other name.
    fn dsl_modulus(self) -> T;
    /// [`arg`], by its other name.
    fn dsl_argument(self) -> T;
    /// Calls [`to_polar`].
    fn dsl_to_polar(self) -> (T, T);
    /// Calls [`powi`].
    fn dsl_powi(&self, exponent: i32) -> Self;
    /// Calls [`powf`].
    fn dsl_powf(self, exponent: T) -> Self;
    /// Calls [`exp`].
    fn dsl_exp(self) -> Self;
    /// Calls [`ln`].
    fn dsl_ln(self) -> Self;
    /// Calls [`sqrt`].
    fn dsl_sqrt(self) -> Self;
    /// Calls [`sin`].
    fn dsl_sin(self) -> Self;
    /// Calls [`cos`].
    fn dsl_cos(self) -> Self;
    /// Calls [`sinh`].
    fn dsl_sinh(self) -> Self;
    /// Calls [`cosh`].
    fn dsl_cosh(self) -> Self;
}

/// Methods of `ComplexField` for real numbers, as in nalgebra; none depends on the platform.
#[doc(hidden)]
pub trait RealMethods: nalgebra::RealField {
    /// The magnitude.
    fn dsl_modulus(self) -> Self {
        nalgebra::ComplexField::modulus(self)
    }
    /// Returns 0, or π for a negative number, rad.
    fn dsl_argument(self) -> Self {
        nalgebra::ComplexField::argument(self)
    }
}

impl<T: nalgebra::RealField> RealMethods for T {}

impl<T: Real> ComplexMethods<T> for Native<T> {
    fn dsl_from_polar(r: T, angle: T) -> Self {
        from_polar(r, angle)
    }
    fn dsl_cis(angle: T) -> Self {
        cis(angle)
    }
    fn dsl_abs(self) -> T {
        abs(&self)
    }
    fn dsl_arg(self) -> T {
        arg(&self)
    }
    fn dsl_modulus(self) -> T {
        abs(&self)
    }
    fn dsl_argument(self) -> T {
        arg(&self)
    }
    fn dsl_to_polar(self) -> (T, T) {
        to_polar(&self)
    }
    fn dsl_powi(&self, exponent: i32) -> Self {
        powi(self, exponent)
    }
    fn dsl_powf(self, exponent: T) -> Self {
        powf(&self, exponent)
    }
    fn dsl_exp(self) -> Self {
        exp(&self)
    }
    fn dsl_ln(self) -> Self {
        ln(&self)
    }
    fn dsl_sqrt(self) -> Self {
        sqrt(&self)
    }
    fn dsl_sin(self) -> Self {
        sin(&self)
    }
    fn dsl_cos(self) -> Self {
        cos(&self)
    }
    fn dsl_sinh(self) -> Self {
        sinh(&self)
    }
    fn dsl_cosh(self) -> Self {
        cosh(&self)
    }
}

#[diagnostic::do_not_recommend]
impl<T: Plain> Plain for Native<T> {
    const WORDS: usize = 2 * T::WORDS;
    fn store(&self, out: &mut dyn FnMut(u64)) {
        self.re.store(out);
        self.im.store(out);
    }
    fn load(next: &mut dyn FnMut() -> u64) -> Self {
        let re = T::load(next);
        Native { re, im: T::load(next) }
    }
}
