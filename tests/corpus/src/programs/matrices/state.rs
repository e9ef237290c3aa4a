//! Matrices in structs and in the state of components.

use bessemer::prelude::*;

/// A tracker of a position and its speed with fixed gains.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Tracker {
    state: Vector2<f64>,
    gains: Vector2<f64>,
}

impl Default for Tracker {
    fn default() -> Self {
        Tracker { state: Vector2::zeros(), gains: Vector2::new(0.5, 0.25) }
    }
}

#[component]
impl Tracker {
    /// Takes the position in m measured `time` s after the last; returns position and speed.
    #[entry(infallible)]
    pub fn step(&mut self, measured: f64, time: f64) -> Vector2<f64> {
        let predicted = Matrix2::new(1.0, time, 0.0, 1.0) * self.state;
        let surprise = measured - predicted.x;
        self.state = predicted + self.gains * surprise;
        self.state
    }
}
