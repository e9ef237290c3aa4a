//! Attitude propagation by a quaternion over one period of constant rates.

use bessemer::prelude::*;

/// The attitude after `time` s at `rate` rad/s.
#[function]
pub fn turned(attitude: &Vector4<f64>, rate: &Vector3<f64>, time: f64) -> Vector4<f64> {
    let angle = rate.norm() * time;
    let scale = if angle > 1e-9 { (angle / 2.0).sin() / rate.norm() } else { time / 2.0 };
    let cosine = (angle / 2.0).cos();
    let [x, y, z] = [rate.x * scale, rate.y * scale, rate.z * scale];
    let matrix = Matrix4::new(
        cosine, -x, -y, -z,
        x, cosine, z, -y,
        y, -z, cosine, x,
        z, y, -x, cosine,
    );
    let next = matrix * attitude;
    next / next.norm()
}
