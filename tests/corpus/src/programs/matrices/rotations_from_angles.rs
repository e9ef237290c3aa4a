//! Rotations from angles, and angles from rotations: nalgebra's operations over the DSL's own sine and cosine.

use bessemer::prelude::*;
use bessemer::rotation;

/// A sensor's reading in the vehicle's frame, for the vehicle's angles in rad.
#[function]
pub fn in_vehicle(roll: f64, pitch: f64, yaw: f64, reading: &Vector3<f64>) -> Vector3<f64> {
    rotation::from_euler_angles(roll, pitch, yaw) * reading
}

/// Integrates the rates of a gyroscope to an orientation.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gyro {
    /// Rotation from the body's frame to the world's.
    pub attitude: UnitQuaternion<f64>,
}

#[component]
impl Gyro {
    /// One period in s with rates in rad/s; returns roll, pitch and yaw in rad.
    #[entry(infallible)]
    pub fn step(&mut self, rates: &Vector3<f64>, period: f64) -> Vector3<f64> {
        self.attitude *= rotation::from_scaled_axis(rates * period);
        self.attitude.renormalize_fast();
        let (roll, pitch, yaw) = rotation::euler_angles(&self.attitude);
        Vector3::new(roll, pitch, yaw)
    }
}

/// The orientation half-way between two, and the angle between them, rad.
#[function]
pub fn middle(one: &UnitQuaternion<f32>, other: &UnitQuaternion<f32>) -> (UnitQuaternion<f32>, f32) {
    (rotation::slerp(one, other, 0.5), rotation::angle_to(one, other))
}

/// Position of a point in the frame of a camera that is rotated about an axis by an angle, rad.
#[function]
pub fn seen(axis: &UnitVector3<f64>, angle: f64, point: &Point3<f64>) -> Point3<f64> {
    rotation::from_axis_angle(axis, angle).inverse_transform_point(point)
}

/// The axis times the angle, rad, of a fraction of a rotation.
#[function]
pub fn part(whole: UnitQuaternion<f64>, share: f64) -> Vector3<f64> {
    rotation::scaled_axis(&whole.powf(share))
}

/// The axis and the angle, rad, of a rotation; `None` for the identity.
#[function]
pub fn about(q: UnitQuaternion<f32>) -> Option<(UnitVector3<f32>, f32)> {
    rotation::axis_angle(&q)
}

/// Converts angles, rad, to a matrix and back.
#[function]
pub fn there_and_back(roll: f64, pitch: f64, yaw: f64) -> (f64, f64, f64) {
    rotation::matrix_euler_angles(&rotation::matrix_from_euler_angles(roll, pitch, yaw))
}

/// A rotation matrix about an axis, and one in the plane.
#[function]
pub fn matrices(axis: &UnitVector3<f64>, angle: f64) -> (Rotation3<f64>, Rotation2<f64>) {
    (rotation::matrix_from_axis_angle(axis, angle), rotation::matrix_from_angle(angle))
}
