//! `Real` is `f32` or `f64`: `real(0.5)` is the literal in either type, and functions have the type's precision.

use bessemer::prelude::*;

/// The height of a projectile after `t` seconds, m.
#[function]
fn height<T: Real>(speed: T, angle: T, t: T) -> T {
    let fall = real::<T>(0.5 * 9.81) * t * t;
    (speed * angle.sin() * t - fall).max(T::ZERO)
}

/// Calls it in single precision.
#[function]
pub fn height_f32(speed: f32, angle: f32, t: f32) -> f32 {
    height(speed, angle, t)
}

/// Calls it in double precision, with the angle in half turns.
#[function]
pub fn height_f64(speed: f64, half_turns: f64, t: f64) -> f64 {
    height(speed, half_turns * f64::PI, t)
}
