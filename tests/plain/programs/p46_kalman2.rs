//! A Kalman filter of two states: position and velocity from range measurements.

use nalgebra::{Matrix1, Matrix2, RowVector2, Vector1, Vector2};

type State = Vector2<f64>;
type Covariance = Matrix2<f64>;

#[derive(Debug, Clone)]
pub struct Kalman {
    x: State,
    p: Covariance,
    q: f64,
    r: Matrix1<f64>,
    gate: f64,
    rejected: usize,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Update {
    Accepted { innovation: f64 },
    Rejected { distance: f64 },
    Singular,
}

impl Kalman {
    const H: RowVector2<f64> = RowVector2::new(1.0, 0.0);

    pub fn new(q: f64, r: f64) -> Self {
        Self {
            x: State::zeros(),
            p: Covariance::from_diagonal_element(100.0),
            q,
            r: Matrix1::new(r),
            gate: 9.0,
            rejected: 0,
        }
    }

    pub fn predict(&mut self, dt: f64, acceleration: f64) {
        let f = Matrix2::new(1.0, dt, 0.0, 1.0);
        let g = Vector2::new(0.5 * dt * dt, dt);
        self.x = f * self.x + g * acceleration;
        self.p = f * self.p * f.transpose() + g * g.transpose() * self.q;
    }

    pub fn update(&mut self, z: f64) -> Update {
        let y = Vector1::new(z) - Self::H * self.x;
        let s = Self::H * self.p * Self::H.transpose() + self.r;
        let Some(s_inv) = s.try_inverse() else {
            return Update::Singular;
        };
        let distance = (y.transpose() * s_inv * y)[0];
        if distance > self.gate {
            self.rejected += 1;
            return Update::Rejected { distance };
        }
        let k = self.p * Self::H.transpose() * s_inv;
        self.x += k * y;
        let i_kh = Covariance::identity() - k * Self::H;
        self.p = i_kh * self.p * i_kh.transpose() + k * self.r * k.transpose();
        self.p = (self.p + self.p.transpose()) * 0.5;
        Update::Accepted { innovation: y.x }
    }

    pub fn position(&self) -> f64 {
        self.x[0]
    }

    pub fn sigma(&self) -> (f64, f64) {
        let d = self.p.diagonal().map(|v| v.max(0.0).sqrt());
        (d[0], d[1])
    }

    pub fn is_healthy(&self) -> bool {
        self.p.iter().all(|v| v.is_finite()) && self.p.cholesky().is_some()
    }
}

pub fn track(measurements: &[f64; 8], dt: f64) -> [f64; 2] {
    let mut filter = Kalman::new(0.1, 0.5);
    for z in measurements {
        filter.predict(dt, 0.0);
        if let Update::Rejected { .. } = filter.update(*z) {
            filter.p *= 2.0;
        }
    }
    filter.x.into()
}

pub fn mean_innovation(measurements: [f64; 8]) -> f64 {
    let mut filter = Kalman::new(0.1, 0.5);
    let (sum, n) = measurements
        .iter()
        .map(|&z| {
            filter.predict(0.1, 0.0);
            filter.update(z)
        })
        .filter_map(|u| match u {
            Update::Accepted { innovation } => Some(innovation),
            _ => None,
        })
        .fold((0.0, 0u32), |(sum, n), i| (sum + i, n + 1));
    if n == 0 { f64::NAN } else { sum / f64::from(n) }
}
