//! Complex numbers: nalgebra's arithmetic, and the functions of `bessemer::complex` instead of the platform's.

use bessemer::complex;
pub use bessemer::nalgebra::Complex;
use bessemer::nalgebra::ComplexField;
use bessemer::prelude::*;

/// A complex number in single precision.
pub type C32 = Complex<f32>;

/// The four operations, also by reference and in place.
#[function]
pub fn arithmetic(a: Complex<f64>, b: &Complex<f64>) -> Complex<f64> {
    let mut sum = a + b;
    sum -= a * b;
    sum *= Complex::new(0.5, b.im);
    sum /= *b;
    -(sum / a) + Complex::i()
}

/// Operations with a real number on either side.
#[function]
pub fn with_reals(z: C32, x: f32) -> [C32; 4] {
    let mut scaled = z * 2.0;
    scaled += x;
    scaled *= x;
    [scaled - 1.0, 1.0 - z / x, x * z, x / z + C32::from(x)]
}

/// Methods that use no function of the platform.
#[function]
pub fn parts(z: Complex<f64>, n: u32) -> (f64, f64, Complex<f64>, bool) {
    let turned = (z.conj() * z.inv()).scale(z.norm_sqr()).unscale(3.0);
    let powers = z.powu(n & 7) + z.powi(-3);
    (turned.re, turned.l1_norm(), powers, z.is_nan() || z.is_infinite() || !powers.is_finite())
}

/// Absolute value and argument.
#[function]
pub fn polar(z: C32, share: f32) -> C32 {
    let (r, angle) = z.to_polar();
    let turned = C32::from_polar(r * share, angle) + C32::cis(z.arg());
    turned.unscale(complex::norm(&z))
}

/// The magnitude of a sum and its square, by the methods of nalgebra's `ComplexField`.
#[function]
pub fn strength(parts: &[Complex<f64>; 3]) -> [f64; 2] {
    let sum: Complex<f64> = parts.iter().sum();
    [sum.modulus(), sum.modulus_squared()]
}

/// Elementary functions.
#[function]
pub fn functions(z: Complex<f64>) -> [Complex<f64>; 5] {
    [z.exp(), z.ln(), z.sqrt(), z.sin() + z.cos(), z.sinh() * z.cosh()]
}

/// A polynomial by Horner's rule.
#[function]
pub fn polynomial<const N: usize>(coefficients: &[f64; N], z: Complex<f64>) -> Complex<f64> {
    let mut value = Complex::<f64>::default();
    for coefficient in coefficients {
        value = value * z + *coefficient;
    }
    value
}

/// The value of an all-pass on the unit circle; `None` if its denominator is 0.
#[function]
pub fn all_pass(angle: f64) -> Option<Complex<f64>> {
    let value = polynomial(&[0.5, -1.0, 0.25], Complex::cis(angle));
    if value == Complex::new(0.0, 0.0) { None } else { Some(value) }
}

/// A filter with one complex pole.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Resonator {
    /// State of the filter.
    pub state: C32,
}

#[component]
impl Resonator {
    /// Filters one sample.
    #[entry(infallible)]
    pub fn step(&mut self, sample: f32, pole: C32) -> f32 {
        self.state = self.state * pole + sample;
        self.state.re
    }
}
