//! Arrays of vectors and matrices.

use bessemer::prelude::*;

/// The mean of four points.
#[function]
pub fn centre(points: &[Vector2<f64>; 4]) -> Vector2<f64> {
    let mut sum = Vector2::zeros();
    for point in points {
        sum += point;
    }
    sum / 4.0
}
