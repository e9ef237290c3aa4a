//! Vectors that are built where an operation reads their elements: no array holds them. A zero is subtracted without a
//! trace, but not a negative one, and none is added.

use bessemer::prelude::*;

/// Zeros of both signs, added and subtracted.
#[function]
pub fn shifted(at: &Vector3<f64>, by: f64) -> (Vector3<f64>, Vector3<f64>) {
    (at - Vector3::new(0.0, -0.0, by), at + Vector3::new(0.0, -0.0, -by))
}

/// A zero from which is subtracted, and the destination among the elements.
#[function]
pub fn turned(at: &mut Vector3<f32>, by: f32) {
    *at -= Vector3::new(at.z, 0.0, at.x);
    *at = Vector3::new(0.0, by, at[1]) - *at;
    *at = (*at * by).component_mul(&Vector3::new(at.y, 1.0, 0.0));
}

/// Elements that are chosen, and negated ones.
#[function]
pub fn chosen(a: &Vector2<f64>, by: f64) -> f64 {
    let kept = a.sup(&Vector2::new(-by, 0.0)).inf(&Vector2::new(1.0, by));
    (kept - Vector2::new(by, -by)).amax()
}

/// Integers, whose differences are checked in order.
#[function]
pub fn counted(a: &Vector2<i8>, b: i8) -> Vector2<i8> {
    a - Vector2::new(b, 0) + Vector2::new(0, b)
}

/// Matrices of four elements, and calls that write one of their elements.
#[function]
pub fn grown(sum: &mut f64, a: &Matrix2<f64>) -> Matrix2<f64> {
    a + Matrix2::new(*sum, 0.0, 1.0, next(sum)) - Matrix2::new(*sum, next(sum), *sum, 0.0)
}

/// Adds one, and returns the sum before.
#[function]
fn next(sum: &mut f64) -> f64 {
    *sum += 1.0;
    *sum - 1.0
}
