//! The air around the aircraft: a steady wind and gusts.
//!
//! Knows forces, not what they act on. Gusts are a first-order Gauss–Markov process for each axis: normally
//! distributed, with a correlation time.

use crate::noise::{Purpose, Stream};
use nalgebra::Vector3;

/// Properties of the air.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Air {
    /// Steady force on the aircraft in the inertial frame, N.
    pub steady: Vector3<f64>,
    /// Standard deviation of the gusts along each axis, N.
    pub gusts: f64,
    /// Correlation time of gusts, s.
    pub memory: f64,
}

/// The present state of the air.
#[derive(Clone, Debug)]
pub struct Wind {
    /// Properties of the air.
    pub air: Air,
    gust: Vector3<f64>,
    stream: Stream,
}

impl Wind {
    /// Creates the air with a seed.
    pub fn new(air: Air, seed: u64) -> Self {
        Self { air, gust: Vector3::zeros(), stream: Stream::new(seed, Purpose::Wind) }
    }

    /// Returns the force on the aircraft over the next `period` seconds, in the inertial frame, N.
    pub fn blow(&mut self, period: f64) -> Vector3<f64> {
        if self.air.gusts > 0.0 {
            let kept = (-period / self.air.memory).exp();
            let fresh = self.air.gusts * (1.0 - kept * kept).sqrt();
            self.gust = self.gust * kept + self.stream.normals() * fresh;
        }
        self.air.steady + self.gust
    }
}
