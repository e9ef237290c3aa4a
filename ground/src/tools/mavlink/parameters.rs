//! The parameters of `models::tuning` in MAVLink's form: with names of at most 16 letters, in single precision.

use crate::testbed::Testbed;
use ::mavlink::dialects::common::*;
use models::tuning::PARAMETER_COUNT;

/// Names of the parameters, at most 16 letters, in the order of `models::tuning`.
const NAMES: [&str; PARAMETER_COUNT] = [
    "HEIGHT_P",
    "HEIGHT_I",
    "HEIGHT_D",
    "ROLL_P",
    "ROLL_I",
    "ROLL_D",
    "PITCH_P",
    "PITCH_I",
    "PITCH_D",
    "YAW_P",
    "YAW_D",
    "X_P",
    "X_D",
    "Y_P",
    "Y_D",
    "FF_GAIN",
    "FF_FRICTION",
    "LAND_RATE",
    "TAKEOFF_EXCESS",
    "CANDIDATE",
    "POINT_SPEED",
    "POINT_ACCEL",
    "POINT_JERK",
];

/// Returns the number of the parameter with a name.
pub fn number_of(name: &str) -> Option<usize> {
    NAMES.iter().position(|it| *it == name)
}

/// Returns the message with a parameter; its value is NaN if it is not known yet.
pub fn parameter(testbed: &Testbed, number: usize) -> MavMessage {
    MavMessage::PARAM_VALUE(PARAM_VALUE_DATA {
        param_value: testbed.station.parameters[number].map_or(f32::NAN, |value| value as f32),
        param_count: PARAMETER_COUNT as u16,
        param_index: number as u16,
        param_id: NAMES[number].into(),
        param_type: MavParamType::MAV_PARAM_TYPE_REAL32,
    })
}

/// Converts to the shortest decimal number: 0.1 became an `f32` in the message, and its limit is an `f64`.
pub fn decimal(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::NAN)
}
