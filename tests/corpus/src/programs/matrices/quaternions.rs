//! Quaternions, not necessarily of length 1.

use bessemer::prelude::*;

/// The derivative of an attitude at angular rates in rad/s.
#[function]
pub fn rate(q: &Quaternion<f64>, rates: &Vector3<f64>) -> Quaternion<f64> {
    q * Quaternion::from_imag(*rates) * 0.5
}

/// Advances an attitude by a period, in s, with the midpoint method of Runge.
#[function]
pub fn step(q: &Quaternion<f64>, rates: &Vector3<f64>, period: f64) -> Quaternion<f64> {
    let first = rate(q, rates);
    let second = rate(&(q + first * (0.5 * period)), rates);
    (q + second * period).normalize()
}

/// Uses all operators.
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

/// Uses dot product and norms.
#[function]
pub fn measures(a: &Quaternion<f32>, b: &Quaternion<f32>) -> [f32; 4] {
    [a.norm(), a.magnitude_squared(), a.dot(b), a.lerp(b, 0.25).squared().scalar()]
}

/// The inverse; `None` if the quaternion is too short.
#[function]
pub fn inverse(q: &Quaternion<f64>) -> Option<Quaternion<f64>> {
    q.try_inverse()
}

/// Constructs a quaternion from its parts and reads them.
#[function]
pub fn parts(scalar: f64, vector: &Vector3<f64>) -> Vector3<f64> {
    let mut q = Quaternion::from_parts(scalar, *vector).conjugate();
    let length = q.normalize_mut();
    q.imag() * length + Quaternion::from_real(scalar).half().imag()
}

/// Tests two quaternions for equality, and the first for zero.
#[function]
pub fn same(a: Quaternion<f64>, b: Quaternion<f64>) -> (bool, bool) {
    (a == b, a == Quaternion::default())
}
