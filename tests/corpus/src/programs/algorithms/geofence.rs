//! Containment of a position in a polygon (the even-odd rule), and its distance from the nearest edge.

use bessemer::prelude::*;

/// Number of corners of the fence.
pub const CORNERS: usize = 6;

/// Distance of a position from the nearest edge, m; negative outside the fence.
#[function]
pub fn inside(fence: &[Vector2<f64>; CORNERS], position: &Vector2<f64>) -> f64 {
    let mut within = false;
    let mut nearest = f64::INFINITY;
    let mut before = fence[CORNERS - 1];
    for corner in fence {
        let edge = corner - before;
        let away = position - before;
        if (corner.y > position.y) != (before.y > position.y)
            && position.x < before.x + edge.x * away.y / edge.y
        {
            within = !within;
        }
        let length = edge.norm_squared();
        let along = if length > 0.0 { (away.dot(&edge) / length).clamp(0.0, 1.0) } else { 0.0 };
        nearest = nearest.min((away - edge * along).norm());
        before = *corner;
    }
    if within { nearest } else { -nearest }
}
