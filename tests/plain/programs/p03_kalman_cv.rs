//! Constant-velocity Kalman filter for one axis: position fixes come in now and
//! then, outliers are gated by the normalised innovation.

use nalgebra::{Matrix2, RowVector2, Vector2};

/// What became of the fix given to [`PosVelKalman::step`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Update {
    /// No fix this period, prediction only.
    Coasted,
    /// Fix used; carries the normalised innovation squared.
    Accepted { nis: f64 },
    /// Fix outside the gate.
    Rejected { nis: f64 },
}

#[derive(Clone, Copy, Debug)]
pub struct Config {
    /// Acceleration noise density, (m/s²)²/Hz.
    pub accel_noise: f64,
    /// Variance of a position fix, m².
    pub fix_variance: f64,
    /// Gate on the normalised innovation squared.
    pub gate: f64,
}

impl Default for Config {
    fn default() -> Self {
        Self { accel_noise: 0.5, fix_variance: 0.25, gate: 9.0 }
    }
}

/// Filter with state `[position, velocity]`.
#[derive(Clone, Debug)]
pub struct PosVelKalman {
    cfg: Config,
    x: Vector2<f64>,
    p: Matrix2<f64>,
    rejected_in_row: u8,
}

impl PosVelKalman {
    const H: RowVector2<f64> = RowVector2::new(1.0, 0.0);
    /// After this many rejections the filter believes the sensor again.
    const MAX_REJECTED: u8 = 5;

    pub fn new(cfg: Config, position: f64) -> Self {
        Self {
            cfg,
            x: Vector2::new(position, 0.0),
            p: Matrix2::from_diagonal(&Vector2::new(cfg.fix_variance, 10.0)),
            rejected_in_row: 0,
        }
    }

    /// Predicts over `dt` and folds in the fix if there is one.
    pub fn step(&mut self, dt: f64, fix: Option<f64>) -> Update {
        self.predict(dt);
        match fix {
            Some(z) if z.is_finite() => self.correct(z),
            _ => Update::Coasted,
        }
    }

    fn predict(&mut self, dt: f64) {
        let f = Matrix2::new(1.0, dt, 0.0, 1.0);
        let (dt2, dt3) = (dt * dt, dt * dt * dt);
        let q = Matrix2::new(dt3 / 3.0, dt2 / 2.0, dt2 / 2.0, dt) * self.cfg.accel_noise;
        self.x = f * self.x;
        self.p = f * self.p * f.transpose() + q;
    }

    fn correct(&mut self, z: f64) -> Update {
        let innovation = z - (Self::H * self.x)[0];
        let s = (Self::H * self.p * Self::H.transpose())[0] + self.cfg.fix_variance;
        let nis = innovation * innovation / s;

        if nis > self.cfg.gate && self.rejected_in_row < Self::MAX_REJECTED {
            self.rejected_in_row += 1;
            return Update::Rejected { nis };
        }
        self.rejected_in_row = 0;

        let k = self.p * Self::H.transpose() / s;
        self.x += k * innovation;
        // Joseph form keeps the covariance symmetric and positive.
        let i_kh = Matrix2::identity() - k * Self::H;
        self.p = i_kh * self.p * i_kh.transpose() + k * k.transpose() * self.cfg.fix_variance;
        Update::Accepted { nis }
    }

    pub fn position(&self) -> f64 {
        self.x.x
    }

    pub fn velocity(&self) -> f64 {
        self.x.y
    }

    /// One-sigma of position and velocity.
    pub fn sigma(&self) -> Vector2<f64> {
        self.p.diagonal().map(f64::sqrt)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn learns_the_velocity() {
        let mut kf = PosVelKalman::new(Config::default(), 0.0);
        for n in 1..=200 {
            let t = n as f64 * 0.1;
            let noise = if n % 2 == 0 { 0.2 } else { -0.2 };
            let fix = (n % 3 != 0).then_some(2.0 * t + noise);
            kf.step(0.1, fix);
        }
        assert!((kf.velocity() - 2.0).abs() < 0.3, "{}", kf.velocity());
        assert!((kf.position() - 40.0).abs() < 0.3);
    }

    #[test]
    fn outlier_is_gated_and_step_is_accepted_at_last() {
        let mut kf = PosVelKalman::new(Config::default(), 0.0);
        for _ in 0..100 {
            kf.step(0.1, Some(0.0));
        }
        assert!(matches!(kf.step(0.1, Some(50.0)), Update::Rejected { nis } if nis > 9.0));
        assert!(kf.position().abs() < 0.1);
        let last = (0..10).map(|_| kf.step(0.1, Some(50.0))).find(|u| matches!(u, Update::Accepted { .. }));
        assert!(last.is_some());
    }

    #[test]
    fn coasting_grows_the_uncertainty() {
        let mut kf = PosVelKalman::new(Config::default(), 1.0);
        let before = kf.sigma();
        assert_eq!(kf.step(1.0, Some(f64::NAN)), Update::Coasted);
        assert!(kf.sigma().x > before.x);
    }
}
