//! Real motors: their speed follows the command with a delay, and they may fail.

use nalgebra::SVector;

/// The motors of one aircraft.
#[derive(Clone, Debug, PartialEq)]
pub struct Motors {
    /// Speed of each motor, rad/s.
    pub speeds: SVector<f64, 8>,
    /// Time constant with which a motor follows its command, s.
    pub lag: f64,
    /// Index of the stopped motor.
    pub dead: Option<usize>,
}

impl Motors {
    /// Creates motors at rest.
    pub fn new(lag: f64) -> Self {
        Self { speeds: SVector::zeros(), lag, dead: None }
    }

    /// Advances the speeds by `period` seconds towards `wanted`, rad/s, and returns their mean squares, to which thrust
    /// is proportional.
    pub fn turn(&mut self, wanted: &SVector<f64, 8>, period: f64) -> SVector<f64, 8> {
        let kept = if self.lag > 0.0 { (-period / self.lag).exp() } else { 0.0 };
        let mut goal = wanted.abs();
        if let Some(dead) = self.dead {
            goal[dead] = 0.0;
        }
        let end = goal + (self.speeds - goal) * kept;
        let middle = (self.speeds + end) / 2.0;
        self.speeds = end;
        middle.component_mul(&middle)
    }
}
