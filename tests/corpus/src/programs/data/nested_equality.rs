//! `==` of nested types is a function in the C, one for each type. Floats compare as in IEEE 754: a NaN anywhere
//! makes the values unequal.

use bessemer::prelude::*;

/// Commands of an axis.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum AxisWish {
    #[default]
    Rest,
    Hold([f32; 2]),
    Turn { to: f32, within: Option<u16> },
}

/// A point of a route.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RoutePoint {
    pub place: Vector2<f32>,
    pub wish: AxisWish,
}

/// A route of three points.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Route {
    pub points: [RoutePoint; 3],
    pub home: Option<RoutePoint>,
    pub turned: UnitQuaternion<f64>,
}

/// Returns true if the new route differs from the old one.
#[function]
pub fn is_changed(old: &Route, new: &Route) -> bool {
    old != new
}

/// Number of points of a route that equal a point.
#[function]
pub fn count(route: &Route, point: &RoutePoint) -> u32 {
    let mut count = 0;
    for other in &route.points {
        if other == point {
            count += 1;
        }
    }
    if route.home == Some(*point) { count + 1 } else { count }
}

/// Returns true if two lists of commands are equal.
#[function]
pub fn same_lists(one: &List<AxisWish, 3>, other: &List<AxisWish, 3>) -> bool {
    one == other
}
