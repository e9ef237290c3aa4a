//! A geometric control law: errors are computed on the rotation itself, not on its angles. Source: Lee, Leok and
//! McClamroch, "Geometric tracking control of a quadrotor UAV on SE(3)", 2010.
//!
//! One of the control laws of the controller. It has no integral, and its errors have no singularity below half a
//! turn. The target attitude is specified in the thesis' angles because the interface is.

use crate::airframe::{GRAVITY, Wrench};
use crate::geometry::Orientation;
use crate::parameters::Parameters;
use crate::signals::{Estimate, Target};
use bessemer::prelude::*;

/// Largest tilt setpoint, rad.
#[data]
const TILT_LIMIT: f64 = 0.6;

/// Returns the thrust and the torques that take the aircraft to its target.
#[function]
pub fn track(parameters: &Parameters, estimate: &Estimate, target: &Target) -> Wrench {
    let rotation = Orientation::of(&estimate.angles).rotation();
    let force = wanted_force(parameters, estimate, target);

    // The requested thrust has the direction (−sin θ2, sin θ1 cos θ2, cos θ1 cos θ2).
    let mut roll = force.y.atan2(force.z).clamp(-TILT_LIMIT, TILT_LIMIT);
    let mut pitch = (-force.x).atan2(force.y.hypot(force.z)).clamp(-TILT_LIMIT, TILT_LIMIT);
    if target.manual {
        roll = target.lean.x;
        pitch = target.lean.y;
    }
    let wanted = Orientation::of(&Vector3::new(roll, pitch, target.yaw)).rotation();

    // The attitude error is the antisymmetric part of the rotation between the two.
    let difference = wanted.transpose() * rotation;
    let error = Vector3::new(
        0.5 * (difference[(2, 1)] - difference[(1, 2)]),
        0.5 * (difference[(0, 2)] - difference[(2, 0)]),
        0.5 * (difference[(1, 0)] - difference[(0, 1)]),
    );
    let error_rate = estimate.rates - Vector3::new(0.0, 0.0, -target.yaw_rate);
    let gains = parameters.geometric.attitude;
    let turn = -(error * gains.p + error_rate * gains.d);
    let inertia = parameters.inertia;
    let gyroscopic = estimate.rates.cross(&inertia.component_mul(&estimate.rates));

    let upwards = Vector3::new(rotation[(0, 2)], rotation[(1, 2)], rotation[(2, 2)]);
    Wrench { thrust: force.dot(&upwards), torque: inertia.component_mul(&turn) + gyroscopic }
}

/// Returns the requested force of the motors in the inertial frame, N.
#[function]
fn wanted_force(parameters: &Parameters, estimate: &Estimate, target: &Target) -> Vector3<f64> {
    let weight = Vector3::new(0.0, 0.0, parameters.mass * GRAVITY);
    if target.take_off {
        return weight * (1.0 + parameters.takeoff_gain);
    }
    let gains = parameters.geometric.place;
    let error = target.position - estimate.position;
    let error_rate = target.velocity - estimate.velocity;
    let along = target.acceleration;
    let planned = Vector3::new(along.x, along.y, target.climb_acceleration);
    weight + (error * gains.p + error_rate * gains.d + planned) * parameters.mass
}
