//! Clarke's and Park's transforms and their inverses, in the power-variant form.

use bessemer::prelude::*;

/// Two of three phase currents as a vector in the stator's frame.
#[function]
pub fn clarke(a: f32, b: f32) -> Vector2<f32> {
    const ROOT: f32 = 0.577_350_26;
    Vector2::new(a, (a + 2.0 * b) * ROOT)
}

/// The vector in the frame of a rotor at `angle`.
#[function]
pub fn park(v: &Vector2<f32>, angle: f32) -> Vector2<f32> {
    let (sine, cosine) = (angle.sin(), angle.cos());
    Vector2::new(v.x * cosine + v.y * sine, v.y * cosine - v.x * sine)
}

/// The vector in the stator's frame, from the rotor's frame.
#[function]
pub fn park_inverse(v: &Vector2<f32>, angle: f32) -> Vector2<f32> {
    let (sine, cosine) = (angle.sin(), angle.cos());
    Matrix2::new(cosine, -sine, sine, cosine) * v
}
