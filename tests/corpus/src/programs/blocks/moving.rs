//! An axis that moves on trajectories of each kind.

use bessemer::prelude::*;
pub use bessemer_blocks::{MinimumJerk, MinimumSnap, Point, SCurve, Trapezoid};

/// Moves an axis to a target with limited jerk.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MovedAxis {
    curve: SCurve<f32>,
    start: f32,
    time: f32,
}

#[component]
impl MovedAxis {
    /// Starts a motion from one position to another, m.
    #[entry(infallible)]
    pub fn start(&mut self, from: f32, to: f32) {
        self.curve = SCurve::plan(to - from, 0.5, 2.0, 20.0);
        self.start = from;
        self.time = 0.0;
    }

    /// Advances one period of 1 ms; returns the set point.
    #[entry(infallible, single)]
    pub fn step(&mut self) -> Point<f32> {
        self.time = (self.time + 1e-3).min(self.curve.duration());
        let mut point = self.curve.at(self.time);
        point.position += self.start;
        point
    }
}

/// The state at a time on a trajectory of three segments.
#[function]
pub fn three_segments(distance: f64, speed: f64, acceleration: f64, time: f64) -> Point<f64> {
    let trapezoid = Trapezoid::plan(distance, speed, acceleration);
    trapezoid.at(time * trapezoid.duration())
}

/// The state at a time on an S-curve.
#[function]
pub fn s_curve(distance: f64, limits: &Vector3<f64>, time: f64) -> Point<f64> {
    let curve = SCurve::plan(distance, limits.x, limits.y, limits.z);
    curve.at(time * curve.duration())
}

/// The state at a time on the smoothest motions between two states, by jerk and by snap.
#[function]
pub fn smoothest(from: &Point<f64>, to: &Point<f64>, duration: f64, time: f64) -> [Point<f64>; 2] {
    [
        MinimumJerk::between(from, to, duration).at(time),
        MinimumSnap::between(from, to, duration).at(time),
    ]
}
