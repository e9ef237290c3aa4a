//! Real motors: their speed follows the command with a delay, and they may fail.

use bessemer::math::ElementaryMethods;
use bessemer_lanes::Number;
use nalgebra::SVector;

/// The motors of one aircraft.
#[derive(Clone, Debug, PartialEq)]
pub struct Motors {
    /// Speed of each motor, rad/s.
    pub speeds: SVector<f64, 8>,
    /// Index of the stopped motor.
    pub dead: Option<usize>,
    lag: f64,
    /// A period, s, and the share of a difference that is left after it.
    kept: (f64, f64),
}

impl Motors {
    /// Creates motors at rest that follow their command with a time constant, s.
    pub fn new(lag: f64) -> Self {
        Self { speeds: SVector::zeros(), lag, dead: None, kept: (0.0, 1.0) }
    }

    /// Advances the speeds by `period` seconds towards `wanted`, rad/s, and returns their mean squares, to which thrust
    /// is proportional.
    pub fn turn(&mut self, wanted: &SVector<f64, 8>, period: f64) -> SVector<f64, 8> {
        if self.kept.0 != period {
            self.kept = (period, kept(period, self.lag));
        }
        let mut squares = SVector::zeros();
        for motor in 0..8 {
            let stopped = self.dead == Some(motor);
            let goal = if stopped { 0.0 } else { wanted[motor].abs() };
            (self.speeds[motor], squares[motor]) = turned(self.speeds[motor], goal, self.kept.1);
        }
        squares
    }
}

/// Returns the share of a motor's difference from its command that is left after a period, s.
pub(crate) fn kept(period: f64, lag: f64) -> f64 {
    if lag > 0.0 { (-period / lag).dsl_exp() } else { 0.0 }
}

/// Returns the speed of a motor after a period, and the mean square in it. `kept` is the share of the difference from the
/// goal that is left.
pub(crate) fn turned<T: Number>(speed: T, goal: T, kept: T) -> (T, T) {
    let end = goal + (speed - goal) * kept;
    let middle = (speed + end) / T::of(2.0);
    (end, middle * middle)
}
