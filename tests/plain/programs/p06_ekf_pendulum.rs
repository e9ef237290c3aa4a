//! Extended Kalman filter for a damped pendulum with several kinds of sensor.

use nalgebra::{Matrix2, RowVector2, Vector2};

/// `[angle, rate]` in rad and rad/s.
pub type State = Vector2<f64>;

/// A scalar sensor the filter can fuse.
pub trait Sensor {
    /// Measurement noise variance.
    const VARIANCE: f64;

    fn expected(&self, x: &State) -> f64;
    fn jacobian(&self, x: &State) -> RowVector2<f64>;
}

/// Horizontal position of the tip, m.
#[derive(Clone, Copy, Debug)]
pub struct TipPosition {
    pub length: f64,
}

/// Rate gyro on the rod, rad/s.
#[derive(Clone, Copy, Debug, Default)]
pub struct RateGyro;

impl Sensor for TipPosition {
    const VARIANCE: f64 = 1e-4;

    fn expected(&self, x: &State) -> f64 {
        self.length * x[0].sin()
    }

    fn jacobian(&self, x: &State) -> RowVector2<f64> {
        RowVector2::new(self.length * x[0].cos(), 0.0)
    }
}

impl Sensor for RateGyro {
    const VARIANCE: f64 = 4e-4;

    fn expected(&self, x: &State) -> f64 {
        x[1]
    }

    fn jacobian(&self, _: &State) -> RowVector2<f64> {
        RowVector2::new(0.0, 1.0)
    }
}

#[derive(Clone, Copy, Debug)]
pub struct Pendulum {
    pub length: f64,
    pub damping: f64,
}

impl Pendulum {
    const G: f64 = 9.81;

    fn derivative(&self, x: &State) -> State {
        let [angle, rate] = (*x).into();
        State::new(rate, -Self::G / self.length * angle.sin() - self.damping * rate)
    }

    /// One midpoint step of the motion.
    pub fn propagate(&self, x: &State, dt: f64) -> State {
        let half = x + self.derivative(x) * (0.5 * dt);
        x + self.derivative(&half) * dt
    }

    fn transition(&self, x: &State, dt: f64) -> Matrix2<f64> {
        let continuous =
            Matrix2::new(0.0, 1.0, -Self::G / self.length * x[0].cos(), -self.damping);
        Matrix2::identity() + continuous * dt
    }
}

#[derive(Clone, Debug)]
pub struct PendulumEkf {
    model: Pendulum,
    x: State,
    p: Matrix2<f64>,
    q: Matrix2<f64>,
}

impl PendulumEkf {
    pub fn new(model: Pendulum, initial: State) -> Self {
        Self {
            model,
            x: initial,
            p: Matrix2::identity() * 0.5,
            q: Matrix2::from_diagonal(&Vector2::new(1e-6, 1e-3)),
        }
    }

    pub fn predict(&mut self, dt: f64) {
        let f = self.model.transition(&self.x, dt);
        self.x = self.model.propagate(&self.x, dt);
        self.p = f * self.p * f.transpose() + self.q * dt;
    }

    /// Fuses one reading; `None` if it was not finite or the gain degenerate.
    pub fn fuse<S: Sensor>(&mut self, sensor: &S, reading: f64) -> Option<f64> {
        let innovation = Some(reading - sensor.expected(&self.x)).filter(|v| v.is_finite())?;
        let h = sensor.jacobian(&self.x);
        let pht = self.p * h.transpose();
        let s = h.dot(&pht.transpose()) + S::VARIANCE;
        if s <= 0.0 {
            return None;
        }
        let k = pht / s;
        self.x += k * innovation;
        self.p -= k * pht.transpose();
        self.p = (self.p + self.p.transpose()) * 0.5;
        Some(innovation)
    }

    /// The period's work: predict, then whatever readings are there.
    pub fn step(&mut self, dt: f64, tip: Option<f64>, gyro: Option<f64>) -> &State {
        self.predict(dt);
        let tip_sensor = TipPosition { length: self.model.length };
        tip.and_then(|z| self.fuse(&tip_sensor, z));
        gyro.and_then(|z| self.fuse(&RateGyro, z));
        &self.x
    }

    pub fn trace(&self) -> f64 {
        self.p.trace()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODEL: Pendulum = Pendulum { length: 0.5, damping: 0.1 };

    #[test]
    fn tracks_from_a_wrong_start() {
        let mut truth = State::new(0.8, 0.0);
        let mut ekf = PendulumEkf::new(MODEL, State::new(0.2, 0.5));
        for n in 0..500 {
            truth = MODEL.propagate(&truth, 0.01);
            let tip = (n % 5 == 0).then(|| MODEL.length * truth[0].sin());
            ekf.step(0.01, tip, Some(truth[1]));
        }
        let error = (ekf.step(0.0, None, None) - truth).norm();
        assert!(error < 0.02, "{error}");
        assert!(ekf.trace() < 0.01);
    }

    #[test]
    fn ignores_a_broken_reading() {
        let mut ekf = PendulumEkf::new(MODEL, State::zeros());
        assert!(ekf.fuse(&RateGyro, f64::NAN).is_none());
        let before = ekf.trace();
        assert!(ekf.fuse(&RateGyro, 0.1).is_some());
        assert!(ekf.trace() < before);
    }
}
