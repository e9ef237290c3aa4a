//! Rotations from angles: nalgebra's operations over the DSL's own sine and cosine.

use bessemer::prelude::*;
use bessemer::rotation::Turn;

/// A sensor's reading in the frame of the vehicle that carries it at these angles, rad.
#[function]
pub fn in_vehicle(roll: f64, pitch: f64, yaw: f64, reading: &Vector3<f64>) -> Vector3<f64> {
    Turn::of_euler_angles(roll, pitch, yaw).rotate(reading)
}

/// Keeps an orientation by the rates of a gyroscope.
#[component]
#[derive(Clone, Debug, PartialEq)]
pub struct Gyro {
    /// From the body to the world.
    pub turn: Turn<f64>,
}

impl Default for Gyro {
    fn default() -> Self {
        Gyro { turn: Turn { i: 0.0, j: 0.0, k: 0.0, w: 1.0 } }
    }
}

#[component]
impl Gyro {
    /// One period, s, at these rates, rad/s: roll, pitch and yaw, rad.
    #[entry(infallible)]
    pub fn step(&mut self, rates: &Vector3<f64>, period: f64) -> Vector3<f64> {
        let part = Turn::of_scaled_axis(&(rates * period));
        self.turn = self.turn.after(&part).renormalized();
        self.turn.roll_pitch_yaw()
    }
}

/// Half of the way between two orientations, each the axis times the angle, rad, as a matrix.
#[function]
pub fn middle(one: &Vector3<f32>, other: &Vector3<f32>) -> Matrix3<f32> {
    let one = Turn::of_scaled_axis(one);
    let other = Turn::of_scaled_axis(other);
    one.towards(&other, 0.5).after(&other.inverse()).matrix()
}

/// What a camera that turns about an axis of length 1 sees of the world, its own angle, rad, back.
#[function]
pub fn seen(axis: &Vector3<f32>, angle: f32, point: &Vector3<f32>) -> Vector3<f32> {
    Turn::about(axis, angle).rotate_back(point)
}
