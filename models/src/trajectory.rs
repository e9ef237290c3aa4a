//! Trajectories: timed set points (thesis, §6.1).
//!
//! A trajectory is checked as a whole before it is used. The control law is unknown here.

use bessemer::prelude::*;

/// Largest number of set points in a trajectory.
#[data]
pub const MAX_POINTS: usize = 16;

/// A setpoint that is valid from a time on.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SetPoint {
    /// Start, in seconds since take-off.
    pub time: f64,
    /// Position in the inertial frame, m.
    pub position: Vector3<f64>,
    /// Yaw, rad.
    pub yaw: f64,
}

/// Set points in order of time.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Trajectory {
    /// Number of set points.
    pub count: usize,
    /// Set points, followed by unused ones.
    pub points: [SetPoint; MAX_POINTS],
}

/// Limits of trajectories.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Space {
    /// Largest distance from the start along x and along y, m.
    pub reach: f64,
    /// Least and largest height of a set point, m.
    pub heights: Vector2<f64>,
    /// Largest time of a set point, s.
    pub latest: f64,
}

#[data]
impl Trajectory {
    /// Returns true if the trajectory is valid: at least one point, each within the space, times increasing from 0. NaN
    /// is never valid.
    #[requirement("HLR-30")]
    pub fn is_sound(&self, space: &Space) -> bool {
        let mut sound = self.count >= 1 && self.count <= MAX_POINTS;
        let mut before = -1.0;
        for n in 0..MAX_POINTS {
            if n < self.count {
                let point = self.points[n];
                let later = point.time > before && point.time >= 0.0 && point.time <= space.latest;
                sound = sound && later && point.is_inside(space);
                before = point.time;
            }
        }
        sound
    }

    /// Returns the set point at a time since take-off, s: the last that has started, or else the first.
    pub fn at(&self, time: f64) -> SetPoint {
        let mut wanted = self.points[0];
        for n in 1..MAX_POINTS {
            if n < self.count && self.points[n].time <= time {
                wanted = self.points[n];
            }
        }
        wanted
    }
}

#[data]
impl SetPoint {
    /// Returns true if the set point is within the space and its yaw within one turn.
    #[requirement("HLR-30")]
    pub fn is_inside(&self, space: &Space) -> bool {
        let place = self.position;
        let near = place.x.abs() <= space.reach && place.y.abs() <= space.reach;
        let between = place.z >= space.heights.x && place.z <= space.heights.y;
        near && between && self.yaw.abs() <= 2.0 * core::f64::consts::PI
    }
}
