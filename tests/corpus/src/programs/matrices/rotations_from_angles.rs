//! Rotations from angles, and angles from rotations: nalgebra's operations over the DSL's own sine and cosine.

use bessemer::prelude::*;
use bessemer::rotation;

/// A sensor's reading in the frame of the vehicle that carries it at these angles, rad.
#[function]
pub fn in_vehicle(roll: f64, pitch: f64, yaw: f64, reading: &Vector3<f64>) -> Vector3<f64> {
    rotation::from_euler_angles(roll, pitch, yaw) * reading
}

/// Keeps an orientation by the rates of a gyroscope.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gyro {
    /// From the body to the world.
    pub attitude: UnitQuaternion<f64>,
}

#[component]
impl Gyro {
    /// One period, s, at these rates, rad/s: roll, pitch and yaw, rad.
    #[entry(infallible)]
    pub fn step(&mut self, rates: &Vector3<f64>, period: f64) -> Vector3<f64> {
        self.attitude *= rotation::from_scaled_axis(rates * period);
        self.attitude.renormalize_fast();
        let (roll, pitch, yaw) = rotation::euler_angles(&self.attitude);
        Vector3::new(roll, pitch, yaw)
    }
}

/// Half of the way between two orientations, and how far it is, rad.
#[function]
pub fn middle(one: &UnitQuaternion<f32>, other: &UnitQuaternion<f32>) -> (UnitQuaternion<f32>, f32) {
    (rotation::slerp(one, other, 0.5), rotation::angle_to(one, other))
}

/// Position of a point in the frame of a camera that is rotated about an axis by an angle, rad.
#[function]
pub fn seen(axis: &UnitVector3<f64>, angle: f64, point: &Point3<f64>) -> Point3<f64> {
    rotation::from_axis_angle(axis, angle).inverse_transform_point(point)
}

/// The axis times the angle, rad, of a part of a rotation.
#[function]
pub fn part(whole: UnitQuaternion<f64>, share: f64) -> Vector3<f64> {
    rotation::scaled_axis(&whole.powf(share))
}

/// The axis and the angle, rad, of a rotation, or none.
#[function]
pub fn about(q: UnitQuaternion<f32>) -> Option<(UnitVector3<f32>, f32)> {
    rotation::axis_angle(&q)
}

/// Angles, rad, to a matrix and back.
#[function]
pub fn there_and_back(roll: f64, pitch: f64, yaw: f64) -> (f64, f64, f64) {
    rotation::matrix_euler_angles(&rotation::matrix_from_euler_angles(roll, pitch, yaw))
}

/// A matrix about an axis, and one in the plane.
#[function]
pub fn matrices(axis: &UnitVector3<f64>, angle: f64) -> (Rotation3<f64>, Rotation2<f64>) {
    (rotation::matrix_from_axis_angle(axis, angle), rotation::matrix_from_angle(angle))
}
