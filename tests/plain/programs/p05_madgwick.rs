//! Madgwick's gradient-descent orientation filter; the magnetometer is optional
//! in every step.

use nalgebra::{Matrix3x4, Quaternion, UnitQuaternion, Vector3, Vector4};

/// Orientation filter, quaternion from body to earth.
#[derive(Clone, Debug)]
pub struct Madgwick {
    q: UnitQuaternion<f64>,
    beta: f64,
    period: f64,
}

impl Madgwick {
    pub const DEFAULT_BETA: f64 = 0.1;

    pub fn new(sample_rate_hz: f64) -> Self {
        debug_assert!(sample_rate_hz > 0.0);
        Self {
            q: UnitQuaternion::identity(),
            beta: Self::DEFAULT_BETA,
            period: 1.0 / sample_rate_hz,
        }
    }

    pub fn with_beta(self, beta: f64) -> Self {
        Self { beta, ..self }
    }

    pub fn orientation(&self) -> UnitQuaternion<f64> {
        self.q
    }

    /// Advances by one sample. Gyro in rad/s; accelerometer and magnetometer in
    /// any unit, zero vectors are ignored.
    pub fn step(
        &mut self,
        gyro: Vector3<f64>,
        accel: Vector3<f64>,
        mag: Option<Vector3<f64>>,
    ) -> UnitQuaternion<f64> {
        let q = self.q.into_inner();
        let mut q_dot = q * Quaternion::from_imag(gyro) * 0.5;

        if let Some(a) = accel.try_normalize(1e-9) {
            let mut gradient = gravity_gradient(&q, &a);
            if let Some(m) = mag.and_then(|m| m.try_normalize(1e-9)) {
                let field = reference_field(&self.q, &m);
                gradient += field_gradient(&q, &m, field);
            }
            if let Some(g) = gradient.try_normalize(1e-12) {
                q_dot -= Quaternion::new(g[0], g[1], g[2], g[3]) * self.beta;
            }
        }

        self.q = UnitQuaternion::from_quaternion(q + q_dot * self.period);
        self.q
    }
}

/// `Jᵀ f` of the gravity objective, ordered w, x, y, z.
fn gravity_gradient(q: &Quaternion<f64>, a: &Vector3<f64>) -> Vector4<f64> {
    let (w, x, y, z) = (q.w, q.i, q.j, q.k);
    let f = Vector3::new(
        2.0 * (x * z - w * y) - a.x,
        2.0 * (w * x + y * z) - a.y,
        2.0 * (0.5 - x * x - y * y) - a.z,
    );
    #[rustfmt::skip]
    let j = Matrix3x4::new(
        -2.0 * y,  2.0 * z, -2.0 * w, 2.0 * x,
         2.0 * x,  2.0 * w,  2.0 * z, 2.0 * y,
         0.0,     -4.0 * x, -4.0 * y, 0.0,
    );
    j.tr_mul(&f)
}

/// Earth field with its horizontal part turned to north: `(north, up)`.
fn reference_field(q: &UnitQuaternion<f64>, m: &Vector3<f64>) -> (f64, f64) {
    let h = q * m;
    (h.xy().norm(), h.z)
}

fn field_gradient(q: &Quaternion<f64>, m: &Vector3<f64>, (bx, bz): (f64, f64)) -> Vector4<f64> {
    let (w, x, y, z) = (q.w, q.i, q.j, q.k);
    let f = Vector3::new(
        2.0 * bx * (0.5 - y * y - z * z) + 2.0 * bz * (x * z - w * y) - m.x,
        2.0 * bx * (x * y - w * z) + 2.0 * bz * (w * x + y * z) - m.y,
        2.0 * bx * (w * y + x * z) + 2.0 * bz * (0.5 - x * x - y * y) - m.z,
    );
    let (bx2, bz2) = (2.0 * bx, 2.0 * bz);
    #[rustfmt::skip]
    let j = Matrix3x4::new(
        -bz2 * y,           bz2 * z,                -2.0 * bx2 * y - bz2 * w, -2.0 * bx2 * z + bz2 * x,
        -bx2 * z + bz2 * x, bx2 * y + bz2 * w,       bx2 * x + bz2 * z,       -bx2 * w + bz2 * y,
         bx2 * y,           bx2 * z - 2.0 * bz2 * x, bx2 * w - 2.0 * bz2 * y,  bx2 * x,
    );
    j.tr_mul(&f)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn converges_to_the_tilt() {
        let truth = UnitQuaternion::from_euler_angles(0.3, -0.5, 0.0);
        let accel = truth.inverse_transform_vector(&Vector3::z());
        let mut f = Madgwick::new(100.0).with_beta(0.5);
        for _ in 0..1000 {
            f.step(Vector3::zeros(), accel, None);
        }
        let up = f.orientation() * accel;
        assert!((up - Vector3::z()).norm() < 0.02, "{up}");
    }

    #[test]
    fn magnetometer_fixes_the_heading() {
        let truth = UnitQuaternion::from_euler_angles(0.2, 0.1, 0.9);
        let accel = truth.inverse_transform_vector(&Vector3::z());
        let mag = truth.inverse_transform_vector(&Vector3::new(0.5, 0.0, -0.8));
        let mut f = Madgwick::new(100.0).with_beta(0.5);
        for _ in 0..2000 {
            f.step(Vector3::zeros(), accel, Some(mag));
        }
        assert!(f.orientation().angle_to(&truth) < 0.03);
    }

    #[test]
    fn free_fall_integrates_gyro_only() {
        let mut f = Madgwick::new(200.0);
        for _ in 0..200 {
            f.step(Vector3::new(0.0, 0.0, 1.0), Vector3::zeros(), Some(Vector3::x()));
        }
        assert!((f.orientation().angle() - 1.0).abs() < 1e-3);
    }
}
