//! Quaternions of any length.

use bessemer::prelude::*;

/// The rate at which an attitude changes at these rates, rad/s.
#[function]
pub fn rate(q: &Quaternion<f64>, rates: &Vector3<f64>) -> Quaternion<f64> {
    q * Quaternion::from_imag(*rates) * 0.5
}

/// One step of Runge's method, of a period, s.
#[function]
pub fn step(q: &Quaternion<f64>, rates: &Vector3<f64>, period: f64) -> Quaternion<f64> {
    let first = rate(q, rates);
    let second = rate(&(q + first * (0.5 * period)), rates);
    (q + second * period).normalize()
}

/// All the operators.
#[function]
pub fn operators(a: Quaternion<f64>, b: &Quaternion<f64>, factor: f64) -> Quaternion<f64> {
    let mut c = -a * b - a / factor + factor * b;
    c += a;
    c -= b;
    c *= *b;
    c *= factor;
    c /= 3.0;
    c.w += 1.0;
    c.conjugate_mut();
    2.0 * c
}

/// The measures.
#[function]
pub fn measures(a: &Quaternion<f32>, b: &Quaternion<f32>) -> [f32; 4] {
    [a.norm(), a.magnitude_squared(), a.dot(b), a.lerp(b, 0.25).squared().scalar()]
}

/// The inverse, or none of what is too short.
#[function]
pub fn inverse(q: &Quaternion<f64>) -> Option<Quaternion<f64>> {
    q.try_inverse()
}

/// From its parts, and apart again.
#[function]
pub fn parts(scalar: f64, vector: &Vector3<f64>) -> Vector3<f64> {
    let mut q = Quaternion::from_parts(scalar, *vector).conjugate();
    let length = q.normalize_mut();
    q.imag() * length + Quaternion::from_real(scalar).half().imag()
}

/// Equality of two quaternions, and a test of the first for zero.
#[function]
pub fn same(a: Quaternion<f64>, b: Quaternion<f64>) -> (bool, bool) {
    (a == b, a == Quaternion::default())
}
