//! An alpha-beta filter: estimates position and speed from position measurements.

use bessemer::prelude::*;

/// The filter's estimate.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AlphaBeta {
    position: f64,
    speed: f64,
}

#[component]
impl AlphaBeta {
    /// Gain of the residual for the position.
    const ALPHA: f64 = 0.85;
    /// Gain of the residual for the speed.
    const BETA: f64 = 0.005;

    /// Takes the position measured `time` s after the last one; returns position and speed.
    #[entry(infallible)]
    pub fn step(&mut self, measured: f64, time: f64) -> [f64; 2] {
        let predicted = self.position + self.speed * time;
        let surprise = measured - predicted;
        self.position = predicted + Self::ALPHA * surprise;
        if time > 0.0 {
            self.speed += Self::BETA * surprise / time;
        }
        [self.position, self.speed]
    }
}
