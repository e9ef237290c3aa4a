//! `==` of what nests is a function in the C, one for each type. Floats compare as IEEE 754 has it: a NaN anywhere
//! makes the whole unequal.

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

/// A point on the way.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RoutePoint {
    pub place: Vector2<f32>,
    pub wish: AxisWish,
}

/// A way of three points.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Route {
    pub points: [RoutePoint; 3],
    pub home: Option<RoutePoint>,
    pub turned: UnitQuaternion<f64>,
}

/// Returns true if a new route is another one.
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

/// Returns true if two lists of wishes are the same.
#[function]
pub fn same_lists(one: &List<AxisWish, 3>, other: &List<AxisWish, 3>) -> bool {
    one == other
}
