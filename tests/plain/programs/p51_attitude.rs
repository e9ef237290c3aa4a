//! Quaternion complementary filter: integrates the gyro and slowly levels the
//! result with the accelerometer whenever the latter looks like pure gravity.

use nalgebra::{UnitQuaternion, Vector3};

pub const STANDARD_GRAVITY: f32 = 9.80665;

/// One reading of a six-axis IMU in body axes (x forward, y left, z up).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ImuSample {
    /// Angular rate in rad/s.
    pub gyro: Vector3<f32>,
    /// Specific force in m/s².
    pub accel: Vector3<f32>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EulerAngles {
    pub roll: f32,
    pub pitch: f32,
    pub yaw: f32,
}

impl From<UnitQuaternion<f32>> for EulerAngles {
    fn from(q: UnitQuaternion<f32>) -> Self {
        let (roll, pitch, yaw) = q.euler_angles();
        Self { roll, pitch, yaw }
    }
}

#[derive(Debug, Clone, Copy)]
pub struct Config {
    /// Time constant of the accelerometer correction in seconds.
    pub time_constant: f32,
    /// Relative deviation from 1 g up to which the accelerometer is trusted.
    pub accel_tolerance: f32,
    /// Gain of the gyro bias estimate in 1/s, zero switches it off.
    pub bias_gain: f32,
}

impl Default for Config {
    fn default() -> Self {
        Self { time_constant: 0.5, accel_tolerance: 0.15, bias_gain: 0.02 }
    }
}

pub struct ComplementaryFilter {
    config: Config,
    attitude: UnitQuaternion<f32>,
    gyro_bias: Vector3<f32>,
}

impl ComplementaryFilter {
    pub fn new(config: Config) -> Self {
        Self { config, attitude: UnitQuaternion::identity(), gyro_bias: Vector3::zeros() }
    }

    /// Body-to-world rotation.
    pub fn attitude(&self) -> UnitQuaternion<f32> {
        self.attitude
    }

    pub fn euler(&self) -> EulerAngles {
        self.attitude.into()
    }

    pub fn gyro_bias(&self) -> &Vector3<f32> {
        &self.gyro_bias
    }

    /// Advances the filter by `dt` seconds and returns the new attitude.
    pub fn update(&mut self, sample: &ImuSample, dt: f32) -> UnitQuaternion<f32> {
        let rate = sample.gyro - self.gyro_bias;
        self.attitude *= UnitQuaternion::from_scaled_axis(rate * dt);

        if let Some(up) = self.trusted_up(&sample.accel) {
            self.level(&up, dt);
        }
        self.attitude.renormalize_fast();
        self.attitude
    }

    /// Direction of "up" in body axes, if the specific force is close to 1 g.
    fn trusted_up(&self, accel: &Vector3<f32>) -> Option<Vector3<f32>> {
        let norm = accel.norm();
        let deviation = (norm / STANDARD_GRAVITY - 1.0).abs();
        (deviation <= self.config.accel_tolerance).then(|| accel / norm)
    }

    fn level(&mut self, up_body: &Vector3<f32>, dt: f32) {
        let measured_up = self.attitude * up_body;
        let fraction = dt / (self.config.time_constant + dt);

        // Exactly upside down there is no unique axis; skip that sample.
        let Some(correction) =
            UnitQuaternion::scaled_rotation_between(&measured_up, &Vector3::z(), fraction)
        else {
            return;
        };
        let error_body = self.attitude.inverse_transform_vector(&measured_up.cross(&Vector3::z()));
        self.gyro_bias -= error_body * (self.config.bias_gain * dt);
        self.attitude = correction * self.attitude;
    }
}

impl Default for ComplementaryFilter {
    fn default() -> Self {
        Self::new(Config::default())
    }
}
