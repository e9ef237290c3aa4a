//! Attributes for the C: a name, a section, and whether a function is inlined.

use bessemer::prelude::*;

/// The torque of a motor at a current, N·m.
#[function]
#[inline(never)]
#[c(name = "motor_torque", section = ".ramfunc")]
pub fn torque(current: f32, constant: f32) -> f32 {
    current * constant
}

/// The electric power that is lost, W.
#[function]
#[inline(always)]
fn power(current: f32, resistance: f32) -> f32 {
    current * current * resistance
}

/// The torque for each watt; `None` without current.
#[function]
pub fn efficiency(current: f32, constant: f32, resistance: f32) -> Option<f32> {
    if current == 0.0 {
        return None;
    }
    Some(torque(current, constant) / power(current, resistance))
}
