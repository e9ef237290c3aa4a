//! Altitude Kalman filter fusing an accelerometer with barometer and GPS.
//! State: altitude, climb rate and vertical accelerometer bias.

use nalgebra::{Matrix3, RowVector3, Vector3};

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Measurement {
    BaroAltitude { metres: f32 },
    GpsAltitude { metres: f32, sigma: f32 },
    GpsClimb { metres_per_second: f32, sigma: f32 },
}

/// Scalar measurement model: z = h·x + v, v ~ N(0, variance).
struct Model {
    value: f32,
    variance: f32,
    row: RowVector3<f32>,
}

impl From<Measurement> for Model {
    fn from(measurement: Measurement) -> Self {
        const BARO_SIGMA: f32 = 0.5;
        let altitude_row = RowVector3::new(1.0, 0.0, 0.0);
        let climb_row = RowVector3::new(0.0, 1.0, 0.0);
        let (value, sigma, row) = match measurement {
            Measurement::BaroAltitude { metres } => (metres, BARO_SIGMA, altitude_row),
            Measurement::GpsAltitude { metres, sigma } => (metres, sigma, altitude_row),
            Measurement::GpsClimb { metres_per_second, sigma } => {
                (metres_per_second, sigma, climb_row)
            }
        };
        Self { value, variance: sigma * sigma, row }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Outcome {
    Fused {
        innovation: f32,
    },
    Rejected {
        distance: f32,
    },
    /// Rejected so often that the filter was re-seeded with the measurement.
    Reseeded,
}

#[derive(Debug, Clone, Copy)]
pub struct Tuning {
    pub accel_sigma: f32,
    pub bias_walk: f32,
    /// Gate on the normalised innovation squared (9 is three sigma).
    pub gate: f32,
    pub max_rejections: u8,
}

impl Default for Tuning {
    fn default() -> Self {
        Self { accel_sigma: 0.4, bias_walk: 0.01, gate: 9.0, max_rejections: 10 }
    }
}

#[derive(Debug, Clone)]
pub struct AltitudeFilter {
    tuning: Tuning,
    state: Vector3<f32>,
    covariance: Matrix3<f32>,
    rejections: u8,
}

impl AltitudeFilter {
    pub fn new(altitude: f32, tuning: Tuning) -> Self {
        Self {
            tuning,
            state: Vector3::new(altitude, 0.0, 0.0),
            covariance: Matrix3::from_diagonal(&Vector3::new(4.0, 1.0, 0.1)),
            rejections: 0,
        }
    }

    pub fn altitude(&self) -> f32 {
        self.state.x
    }

    pub fn climb_rate(&self) -> f32 {
        self.state.y
    }

    /// `accel_up` is the vertical acceleration with gravity removed.
    pub fn predict(&mut self, accel_up: f32, dt: f32) {
        let half_dt2 = 0.5 * dt * dt;
        #[rustfmt::skip]
        let f = Matrix3::new(
            1.0, dt,  -half_dt2,
            0.0, 1.0, -dt,
            0.0, 0.0, 1.0,
        );
        let g = Vector3::new(half_dt2, dt, 0.0);

        let mut process = g * g.transpose() * self.tuning.accel_sigma * self.tuning.accel_sigma;
        process[(2, 2)] += self.tuning.bias_walk * self.tuning.bias_walk * dt;

        self.state = f * self.state + g * accel_up;
        self.covariance = f * self.covariance * f.transpose() + process;
    }

    pub fn fuse(&mut self, measurement: Measurement) -> Outcome {
        let model = Model::from(measurement);
        let innovation = model.value - (model.row * self.state)[0];
        let cross = self.covariance * model.row.transpose();
        let variance = (model.row * cross)[0] + model.variance;

        let distance = innovation * innovation / variance;
        if distance > self.tuning.gate {
            return self.reject(&model, distance);
        }
        self.rejections = 0;

        let gain = cross / variance;
        self.state += gain * innovation;
        let keep = Matrix3::identity() - gain * model.row;
        self.covariance =
            keep * self.covariance * keep.transpose() + gain * gain.transpose() * model.variance;
        Outcome::Fused { innovation }
    }

    fn reject(&mut self, model: &Model, distance: f32) -> Outcome {
        self.rejections += 1;
        if self.rejections < self.tuning.max_rejections {
            return Outcome::Rejected { distance };
        }
        self.rejections = 0;
        let observed = model.row.transpose().iamax();
        self.state[observed] = model.value;
        self.covariance.row_mut(observed).fill(0.0);
        self.covariance.column_mut(observed).fill(0.0);
        self.covariance[(observed, observed)] = model.variance;
        Outcome::Reseeded
    }
}
