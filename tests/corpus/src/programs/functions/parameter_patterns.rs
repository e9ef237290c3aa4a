//! A destructured parameter: its parts are named in the C.

use bessemer::prelude::*;

/// A point, m.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spot {
    pub x: f64,
    pub y: f64,
}

/// The length of a vector.
#[function]
pub fn length((x, y): (f64, f64)) -> f64 {
    (x * x + y * y).sqrt()
}

/// The volume of a box.
#[function]
pub fn volume(&[width, depth, height]: &[f64; 3]) -> f64 {
    width * depth * height
}

/// Slope of the line from the origin to a point.
#[function]
pub fn slope(&Spot { x, y }: &Spot) -> f64 {
    y / x
}

/// The distance from the origin to a point, plus the volume of a box.
#[function]
pub fn all(point: &Spot, sides: &[f64; 3]) -> f64 {
    length((point.x, point.y)) + volume(sides) + slope(point)
}
