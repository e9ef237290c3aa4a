//! A Kalman filter for height and climb from a barometer, with acceleration as input (Joseph form).

use bessemer::prelude::*;

/// Estimate and covariance.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Altimeter {
    state: Vector2<f64>,
    covariance: Matrix2<f64>,
}

impl Default for Altimeter {
    fn default() -> Self {
        Altimeter { state: Vector2::zeros(), covariance: Matrix2::identity() }
    }
}

#[component]
impl Altimeter {
    /// One period of `time` s. Takes the acceleration in m/s² and the height in m; ignores a height that differs from
    /// the prediction by more than `gate`.
    #[entry(infallible)]
    pub fn step(&mut self, acceleration: f64, height: f64, gate: f64, time: f64) -> Vector2<f64> {
        let a = Matrix2::new(1.0, time, 0.0, 1.0);
        let b = Vector2::new(time * time / 2.0, time);
        self.state = a * self.state + b * acceleration;
        self.covariance = a * self.covariance * a.transpose() + b * b.transpose() * 0.04;

        let noise = 0.25;
        let surprise = height - self.state.x;
        let spread = self.covariance[(0, 0)] + noise;
        if surprise * surprise <= gate * gate * spread {
            let gain = Vector2::new(self.covariance[(0, 0)], self.covariance[(1, 0)]) / spread;
            let left = Matrix2::new(1.0 - gain.x, 0.0, -gain.y, 1.0);
            self.state += gain * surprise;
            self.covariance =
                left * self.covariance * left.transpose() + gain * gain.transpose() * noise;
        }
        self.state
    }
}
