//! Points, translations and unit vectors: vectors in the C.

use bessemer::prelude::*;

/// Position of a vehicle, and its previous position.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Way {
    /// Position.
    pub to: Point3<f64>,
    /// Previous position.
    pub from: Point3<f64>,
}

/// Length and midpoint of the way.
#[function]
pub fn halfway(way: &Way) -> (f64, Point3<f64>) {
    let between = way.to - way.from;
    (between.norm(), way.from + between * 0.5)
}

/// Moves a point.
#[function]
pub fn moved(mut point: Point2<f32>, by: Translation2<f32>) -> Point2<f32> {
    point.x += by.x;
    point.coords[1] -= by.vector.y;
    let back = by.inverse() * point;
    by * by * back
}

/// The component of a vector along a direction.
#[function]
pub fn along(vector: &Vector3<f64>, direction: &Vector3<f64>) -> Vector3<f64> {
    let direction = Unit::new_normalize(*direction);
    direction.into_inner() * direction.dot(vector)
}

/// The height of a point above a plane through the origin.
#[function]
pub fn above(point: &Point3<f64>) -> f64 {
    let up = Vector3::z_axis();
    up.dot(&(point - Point3::origin())) + Point3::from(up.into_inner()).z
}
