//! States of estimators: indices, retraction and difference by `derive(State)`, with a rotation and without one.

use bessemer::prelude::*;

/// State of a vehicle.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, State)]
pub struct Motion {
    /// From the body's frame to the world's.
    pub attitude: UnitQuaternion<f64>,
    /// Velocity, m/s.
    pub velocity: Vector3<f64>,
    /// Bias of the barometer, m.
    pub bias: f64,
}

/// Number of the segments of a beam.
pub const SEGMENTS: usize = 3;

/// State of a heated beam.
#[data]
#[derive(Clone, Debug, PartialEq, State)]
pub struct Beam {
    /// Temperatures of the segments, °C.
    pub segments: SVector<f32, SEGMENTS>,
    /// Temperature of the heater, °C.
    pub heater: f32,
}

/// State of an axis in either precision.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, State)]
pub struct Axis<T: Real> {
    /// Angle, rad.
    pub angle: T,
    /// Rates of both gyroscopes, rad/s.
    pub rates: Vector2<T>,
}

/// State of an axis in single precision.
#[data]
pub type SingleAxis = Axis<f32>;

/// An estimate of motion.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Estimate {
    motion: Motion,
}

#[component]
impl Estimate {
    /// Moves the estimate by errors.
    #[entry(infallible)]
    pub fn correct(&mut self, errors: &SVector<f64, { Motion::ERRORS }>) -> f64 {
        self.motion = self.motion.retracted(errors);
        errors[Motion::VELOCITY + 2]
    }

    /// Returns the errors of the estimate beside the truth.
    #[entry(infallible)]
    pub fn errors(&self, truth: &Motion) -> SVector<f64, 7> {
        truth.difference(&self.motion)
    }
}

/// Heats a beam; returns its numbers.
#[function]
pub fn heated(values: &Vector4<f32>, by: f32) -> (Vector4<f32>, Vector4<f32>) {
    let beam = Beam::of_vector(values);
    let mut warmer = beam.clone();
    warmer.heater += by;
    warmer.segments[0] += by;
    (warmer.vector(), warmer.difference(&beam))
}

/// An axis moved by errors.
#[function]
pub fn turned(axis: &Axis<f64>, errors: &Vector3<f64>) -> Axis<f64> {
    axis.retracted(errors)
}
