//! A table over one axis.

use bessemer::prelude::*;

/// Points of a table.
pub const POINTS: usize = 9;

/// The value at a place from 0 to 1, linear between points that are equally far apart; flat beyond the ends.
#[function]
pub fn interpolated(points: &[f32; POINTS], place: f32) -> f32 {
    let place = place.clamp(0.0, 1.0) * (POINTS - 1) as f32;
    let below = (place as u32).min(POINTS as u32 - 2);
    let share = place - below as f32;
    let (low, high) = (points[below as usize], points[(below + 1) as usize]);
    low + share * (high - low)
}
