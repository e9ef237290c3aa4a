//! The air around the aircraft: a steady wind and gusts.
//!
//! Knows forces, not what they act on. Gusts are a first-order Gauss–Markov process for each axis: normally
//! distributed, with a correlation time.

use bessemer::math::ElementaryMethods;

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
    /// A period, s, with the air for which the change is.
    within: (f64, Air),
    /// The share of a gust that is left after the period, and the standard deviation of the new part, N.
    change: (f64, f64),
}

impl Wind {
    /// Creates the air with a seed.
    pub fn new(air: Air, seed: u64) -> Self {
        Self {
            air,
            gust: Vector3::zeros(),
            stream: Stream::new(seed, Purpose::Wind),
            within: (0.0, air),
            change: (1.0, 0.0),
        }
    }

    /// Returns the force on the aircraft over the next `period` seconds, in the inertial frame, N.
    pub fn blow(&mut self, period: f64) -> Vector3<f64> {
        if self.air.gusts > 0.0 {
            if self.within != (period, self.air) {
                let kept = (-period / self.air.memory).dsl_exp();
                self.within = (period, self.air);
                self.change = (kept, self.air.gusts * (1.0 - kept * kept).sqrt());
            }
            let (kept, fresh) = self.change;
            self.gust = self.gust * kept + self.stream.normals() * fresh;
        }
        self.air.steady + self.gust
    }
}
