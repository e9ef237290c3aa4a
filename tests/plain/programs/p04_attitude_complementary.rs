//! Complementary attitude filter on a unit quaternion (body to world, z up):
//! gyro integration, accelerometer levelling and slow gyro-bias estimation.

use nalgebra::{Unit, UnitQuaternion, Vector3};

/// One sample of the inertial unit.
#[derive(Clone, Copy, Debug)]
pub struct ImuSample {
    /// rad/s, body frame.
    pub gyro: Vector3<f32>,
    /// m/s², body frame; at rest it reads +g along the world's up.
    pub accel: Vector3<f32>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EulerAngles {
    pub roll: f32,
    pub pitch: f32,
    pub yaw: f32,
}

/// Complementary filter with proportional and integral feedback.
#[derive(Clone, Debug)]
pub struct AttitudeFilter {
    attitude: UnitQuaternion<f32>,
    bias: Vector3<f32>,
    kp: f32,
    ki: f32,
    levelled: bool,
}

impl Default for AttitudeFilter {
    fn default() -> Self {
        Self {
            attitude: UnitQuaternion::identity(),
            bias: Vector3::zeros(),
            kp: 1.0,
            ki: 0.05,
            levelled: false,
        }
    }
}

impl AttitudeFilter {
    const GRAVITY: f32 = 9.806_65;
    /// Samples whose magnitude is further from 1 g than this share are ignored.
    const ACCEL_TOLERANCE: f32 = 0.15;
    const MAX_BIAS: f32 = 0.2;

    pub fn new(kp: f32, ki: f32) -> Self {
        Self { kp, ki, ..Self::default() }
    }

    /// Runs one period; returns the new attitude.
    pub fn step(&mut self, sample: &ImuSample, dt: f32) -> UnitQuaternion<f32> {
        let error = match Self::usable_up(&sample.accel) {
            Some(up) if !self.levelled => {
                self.level_to(&up);
                Vector3::zeros()
            }
            Some(up) => {
                let predicted = self.attitude.inverse_transform_vector(&Vector3::z());
                up.cross(&predicted)
            }
            None => Vector3::zeros(),
        };

        self.bias -= error * (self.ki * dt);
        self.bias = self.bias.map(|b| b.clamp(-Self::MAX_BIAS, Self::MAX_BIAS));

        let rate = sample.gyro - self.bias + error * self.kp;
        self.attitude *= UnitQuaternion::from_scaled_axis(rate * dt);
        self.attitude.renormalize_fast();
        self.attitude
    }

    /// Direction of "up" in the body frame if the accelerometer can be trusted.
    fn usable_up(accel: &Vector3<f32>) -> Option<Unit<Vector3<f32>>> {
        let (up, norm) = Unit::try_new_and_get(*accel, 1e-3)?;
        let deviation = (norm / Self::GRAVITY - 1.0).abs();
        (deviation < Self::ACCEL_TOLERANCE).then_some(up)
    }

    /// Takes roll and pitch at once from the first good sample.
    fn level_to(&mut self, up: &Unit<Vector3<f32>>) {
        self.attitude =
            UnitQuaternion::rotation_between_axis(up, &Vector3::z_axis()).unwrap_or_else(|| {
                // Upside down: any half turn about a horizontal axis will do.
                UnitQuaternion::from_axis_angle(&Vector3::x_axis(), core::f32::consts::PI)
            });
        self.levelled = true;
    }

    pub fn euler(&self) -> EulerAngles {
        let (roll, pitch, yaw) = self.attitude.euler_angles();
        EulerAngles { roll, pitch, yaw }
    }

    pub fn bias(&self) -> Vector3<f32> {
        self.bias
    }

    /// Acceleration without gravity, in the world frame.
    pub fn linear_acceleration(&self, accel: &Vector3<f32>) -> Vector3<f32> {
        self.attitude * accel - Vector3::z() * Self::GRAVITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at_rest(gyro: Vector3<f32>) -> ImuSample {
        ImuSample { gyro, accel: Vector3::new(0.0, 0.0, 9.81) }
    }

    #[test]
    fn levels_from_the_first_sample() {
        let tilt = UnitQuaternion::from_euler_angles(0.4_f32, -0.2, 0.0);
        let accel = tilt.inverse_transform_vector(&Vector3::new(0.0, 0.0, 9.81));
        let mut f = AttitudeFilter::default();
        f.step(&ImuSample { gyro: Vector3::zeros(), accel }, 0.01);
        let e = f.euler();
        assert!((e.roll - 0.4).abs() < 0.02 && (e.pitch + 0.2).abs() < 0.02, "{e:?}");
        assert!(f.linear_acceleration(&accel).norm() < 0.05);
    }

    #[test]
    fn finds_the_gyro_bias() {
        let mut f = AttitudeFilter::new(1.0, 0.3);
        let bias = Vector3::new(0.03, -0.02, 0.0);
        for _ in 0..6000 {
            f.step(&at_rest(bias), 0.01);
        }
        assert!((f.bias() - bias).norm() < 0.003, "{}", f.bias());
        assert!(f.euler().roll.abs() < 0.01);
    }

    #[test]
    fn integrates_yaw_and_ignores_shocks() {
        let mut f = AttitudeFilter::default();
        for _ in 0..100 {
            f.step(&at_rest(Vector3::new(0.0, 0.0, 0.5)), 0.01);
        }
        assert!((f.euler().yaw - 0.5).abs() < 0.01);
        let shock = ImuSample { gyro: Vector3::zeros(), accel: Vector3::new(40.0, 0.0, 9.81) };
        f.step(&shock, 0.01);
        assert!(f.euler().pitch.abs() < 0.01);
    }
}
