//! The parameters of `models::tuning` as MAVLink has them: by names of at most 16 letters, in single precision.

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
];

/// The number of the parameter of a name.
pub fn number_of(name: &str) -> Option<usize> {
    NAMES.iter().position(|it| *it == name)
}

/// A parameter; what is not known yet is no number.
pub fn parameter(testbed: &Testbed, number: usize) -> MavMessage {
    MavMessage::PARAM_VALUE(PARAM_VALUE_DATA {
        param_value: testbed.station.parameters[number].map_or(f32::NAN, |value| value as f32),
        param_count: PARAMETER_COUNT as u16,
        param_index: number as u16,
        param_id: NAMES[number].into(),
        param_type: MavParamType::MAV_PARAM_TYPE_REAL32,
    })
}

/// The number that was written with the fewest digits: 0.1 became an `f32` on its way, and its bound is an `f64`.
pub fn decimal(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::NAN)
}
