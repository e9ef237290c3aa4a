//! `sin_cos` computes both with one reduction of the angle; the bits are those of `sin` and `cos`.

use bessemer::prelude::*;

/// A vector rotated by an angle, rad.
#[function]
pub fn turned(x: f64, y: f64, angle: f64) -> [f64; 2] {
    let (sine, cosine) = angle.sin_cos();
    [cosine * x - sine * y, sine * x + cosine * y]
}

/// The rotated vector in single precision.
#[function]
pub fn turned_f32(x: f32, y: f32, angle: f32) -> [f32; 2] {
    let (sine, cosine) = angle.sin_cos();
    [cosine * x - sine * y, sine * x + cosine * y]
}
