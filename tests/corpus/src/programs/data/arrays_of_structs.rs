//! Arrays of structs, and structs with arrays.

use bessemer::prelude::*;

/// A setpoint and the time from which it is valid.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Waypoint {
    /// Position, m.
    pub position: [f64; 2],
    /// Start of its validity, s.
    pub time: f64,
}

/// The last waypoint whose time has come.
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
