//! Arrays of structs, and structs with arrays.

use bessemer::prelude::*;

/// A set point and when it begins.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Waypoint {
    /// Position, m.
    pub position: [f64; 2],
    /// Begin, s.
    pub time: f64,
}

/// The last of the waypoints that has begun.
#[function]
pub fn current(plan: &[Waypoint; 4], time: f64) -> Waypoint {
    let mut found = plan[0];
    for i in 1..4 {
        if plan[i].time <= time {
            found = plan[i];
        }
    }
    found
}
