//! Attitude of a vehicle: three estimators, and the control of its attitude.

use bessemer::prelude::*;
pub use bessemer_blocks::{
    AttitudeGains, ErrorStateFilter, ErrorStateNoise, Madgwick, MadgwickGain, Mahony, MahonyGains,
    attitude_error, attitude_torque,
};

/// Estimates an attitude and controls it.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Levelled {
    filter: Mahony<f32>,
}

#[component]
impl Levelled {
    /// Takes one sample of rates, rad/s, and force; returns the torque that levels the body, N·m.
    #[entry(infallible, single)]
    pub fn step(
        &mut self,
        gains: &MahonyGains<f32>,
        control: &AttitudeGains<f32>,
        rates: &Vector3<f32>,
        force: &Vector3<f32>,
    ) -> Vector3<f32> {
        let attitude = self.filter.step(gains, rates, force);
        let level = UnitQuaternion::identity();
        attitude_torque(control, &attitude, rates, &level, &Vector3::zeros())
    }

    /// Returns the direction of up in the body's frame.
    #[entry(infallible, single)]
    pub fn up(&self) -> Vector3<f32> {
        self.filter.up()
    }
}

/// Estimates an attitude by both filters.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Estimators {
    mahony: Mahony<f64>,
    madgwick: Madgwick<f64>,
}

#[component]
impl Estimators {
    /// Takes one sample of rates, rad/s, and force; returns the difference of the estimates, rad.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        mahony: &MahonyGains<f64>,
        madgwick: &MadgwickGain<f64>,
        rates: &Vector3<f64>,
        force: &Vector3<f64>,
    ) -> Vector3<f64> {
        let one = self.mahony.step(mahony, rates, force);
        let other = self.madgwick.step(madgwick, rates, force);
        attitude_error(&one, &other) + self.madgwick.up()
    }
}

/// Estimates an attitude and the bias of its gyroscope, also with a compass.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Compassed {
    filter: ErrorStateFilter<f64>,
}

#[component]
impl Compassed {
    /// Takes one sample of rates, rad/s, and force; returns the attitude.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        noise: &ErrorStateNoise<f64>,
        rates: &Vector3<f64>,
        force: &Vector3<f64>,
    ) -> UnitQuaternion<f64> {
        self.filter.step(noise, rates, force)
    }

    /// Takes one sample of the magnetic field, in any unit; returns the bias of the gyroscope, rad/s, after it.
    #[entry(infallible)]
    pub fn heed(&mut self, north: &Vector3<f64>, field: &Vector3<f64>) -> Vector3<f64> {
        self.filter.correct(north, field, 1e-2, 16.0);
        self.filter.bias()
    }
}
