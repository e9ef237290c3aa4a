//! Where the aircraft is to be, and when: timed set points (thesis, §6.1).
//!
//! Whoever hands one in, it is checked as a whole before it counts. Knows nothing of how the aircraft
//! gets there.

use bessemer::prelude::*;

/// The most set points of a trajectory.
#[data]
pub const MOST_POINTS: usize = 16;

/// A place from a time on.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SetPoint {
    /// From when, in seconds since the take-off.
    pub time: f64,
    /// Where, in the inertial frame, m.
    pub position: Vector3<f64>,
    /// Yaw, rad.
    pub yaw: f64,
}

/// Set points in the order of time.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Trajectory {
    /// How many there are.
    pub count: usize,
    /// They, and unused ones behind them.
    pub points: [SetPoint; MOST_POINTS],
}

/// Where the aircraft may be.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Space {
    /// How far from the start along x and along y, m.
    pub reach: f64,
    /// Lowest and highest set point, m.
    pub heights: Vector2<f64>,
    /// Latest set point, s.
    pub latest: f64,
}

#[data]
impl Trajectory {
    /// Whether it can be flown: at least one point, each within the space, times that grow from 0 on.
    /// What is not a number is in no space, and no time.
    pub fn is_sound(&self, space: &Space) -> bool {
        let mut sound = self.count >= 1 && self.count <= MOST_POINTS;
        let mut before = -1.0;
        for n in 0..MOST_POINTS {
            if n < self.count {
                let point = self.points[n];
                let later = point.time > before && point.time >= 0.0 && point.time <= space.latest;
                sound = sound && later && point.is_inside(space);
                before = point.time;
            }
        }
        sound
    }

    /// The set point at a time since take-off, s: the last that has begun, and before that the first.
    pub fn at(&self, time: f64) -> SetPoint {
        let mut wanted = self.points[0];
        for n in 1..MOST_POINTS {
            if n < self.count && self.points[n].time <= time {
                wanted = self.points[n];
            }
        }
        wanted
    }
}

#[data]
impl SetPoint {
    /// Whether it lies in the space, with a yaw within one turn.
    pub fn is_inside(&self, space: &Space) -> bool {
        let place = self.position;
        let near = place.x.abs() <= space.reach && place.y.abs() <= space.reach;
        let between = place.z >= space.heights.x && place.z <= space.heights.y;
        near && between && self.yaw.abs() <= 2.0 * core::f64::consts::PI
    }
}
