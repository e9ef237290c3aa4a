//! Clarke's and Park's transforms, there and back, power-variant form.

use bessemer::prelude::*;

/// Two of three phase currents as a vector that stands still.
#[function]
pub fn clarke(a: f32, b: f32) -> Vector2<f32> {
    const ROOT: f32 = 0.577_350_26;
    Vector2::new(a, (a + 2.0 * b) * ROOT)
}

/// The vector as the rotor at `angle` sees it.
#[function]
pub fn park(v: &Vector2<f32>, angle: f32) -> Vector2<f32> {
    let (sine, cosine) = (angle.sin(), angle.cos());
    Vector2::new(v.x * cosine + v.y * sine, v.y * cosine - v.x * sine)
}

/// Back from the rotor's frame.
#[function]
pub fn park_inverse(v: &Vector2<f32>, angle: f32) -> Vector2<f32> {
    let (sine, cosine) = (angle.sin(), angle.cos());
    Matrix2::new(cosine, -sine, sine, cosine) * v
}
