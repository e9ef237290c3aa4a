//! Attitude from gyroscope, accelerometer and magnetometer by a complementary filter on quaternions.

use nalgebra::{UnitQuaternion, Vector3};

#[derive(Debug, Clone, Copy)]
pub struct Imu {
    pub gyro: Vector3<f32>,
    pub accel: Vector3<f32>,
    pub mag: Option<Vector3<f32>>,
}

#[derive(Debug, Clone, Copy)]
pub struct Config {
    pub tilt_gain: f32,
    pub heading_gain: f32,
    pub bias_gain: f32,
    pub gravity: f32,
    pub tolerance: f32,
}

impl Default for Config {
    fn default() -> Self {
        Config { tilt_gain: 0.5, heading_gain: 0.1, bias_gain: 0.01, gravity: 9.81, tolerance: 1.5 }
    }
}

#[derive(Debug, Clone)]
pub struct Filter {
    config: Config,
    attitude: UnitQuaternion<f32>,
    bias: Vector3<f32>,
    steps: u32,
}

impl Filter {
    pub fn new(config: Config) -> Self {
        Filter { config, attitude: UnitQuaternion::identity(), bias: Vector3::zeros(), steps: 0 }
    }

    pub fn attitude(&self) -> UnitQuaternion<f32> {
        self.attitude
    }

    fn tilt_error(&self, accel: &Vector3<f32>) -> Option<Vector3<f32>> {
        let norm = accel.norm();
        if (norm - self.config.gravity).abs() > self.config.tolerance {
            return None;
        }
        let measured = accel / norm;
        let expected = self.attitude.inverse() * Vector3::z_axis();
        Some(measured.cross(&expected))
    }

    fn heading_error(&self, mag: &Vector3<f32>) -> Option<Vector3<f32>> {
        let world = self.attitude * mag;
        let flat = Vector3::new(world.x, world.y, 0.0).try_normalize(1e-6)?;
        let error = flat.cross(&Vector3::x());
        Some(self.attitude.inverse_transform_vector(&error))
    }

    pub fn update(&mut self, imu: &Imu, dt: f32) -> [f32; 3] {
        let Config { tilt_gain, heading_gain, bias_gain, .. } = self.config;
        let mut correction = Vector3::zeros();
        if let Some(error) = self.tilt_error(&imu.accel) {
            correction += error * tilt_gain;
        }
        if let Some(error) = imu.mag.as_ref().and_then(|m| self.heading_error(m)) {
            correction += error * heading_gain;
        }
        self.bias -= correction * (bias_gain * dt);
        self.bias.apply(|b| *b = b.clamp(-0.1, 0.1));

        let rate = imu.gyro - self.bias + correction;
        self.attitude *= UnitQuaternion::from_scaled_axis(rate * dt);
        self.steps = self.steps.wrapping_add(1);
        if self.steps % 100 == 0 {
            self.attitude.renormalize();
        }
        let (roll, pitch, yaw) = self.attitude.euler_angles();
        [roll, pitch, yaw]
    }

    pub fn up(&self) -> Vector3<f32> {
        self.attitude.inverse().transform_vector(&Vector3::z())
    }

    pub fn tilt(&self) -> f32 {
        self.up().z.clamp(-1.0, 1.0).acos()
    }
}

pub fn settle(accel: Vector3<f32>, gyro: Vector3<f32>) -> [f32; 3] {
    let mut filter = Filter::new(Config { tilt_gain: 2.0, ..Default::default() });
    let imu = Imu { gyro, accel, mag: None };
    (0..20).map(|_| filter.update(&imu, 0.01)).last().unwrap_or_default()
}
