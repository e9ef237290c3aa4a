//! A geometric law: errors are taken on the rotation itself, not on its angles (after Lee, Leok and
//! McClamroch, "Geometric tracking control of a quadrotor UAV on SE(3)", 2010).
//!
//! A candidate of [`crate::controller`]. It has no memory, and no singularity of its errors below half a
//! turn; that the wanted rotation is written in the thesis' angles is the interface's, not the law's.

use crate::airframe::{GRAVITY, Wrench};
use crate::geometry::Orientation;
use crate::parameters::Parameters;
use crate::signals::{Estimate, Target};
use bessemer::prelude::*;

/// Steepest lean that is asked for, rad.
#[data]
const STEEPEST: f64 = 0.6;

/// The thrust and the torques that take the aircraft to its target.
#[function]
pub fn track(parameters: &Parameters, estimate: &Estimate, target: &Target) -> Wrench {
    let rotation = Orientation::of(&estimate.angles).rotation();
    let force = push(parameters, estimate, target);

    // The thrust that is wanted points along (−sin θ2, sin θ1 cos θ2, cos θ1 cos θ2).
    let mut roll = force.y.atan2(force.z).clamp(-STEEPEST, STEEPEST);
    let mut pitch = (-force.x).atan2(force.y.hypot(force.z)).clamp(-STEEPEST, STEEPEST);
    if target.manual {
        roll = target.lean.x;
        pitch = target.lean.y;
    }
    let wanted = Orientation::of(&Vector3::new(roll, pitch, target.yaw)).rotation();

    // The turn that is left, as the antisymmetric part of the rotation between the two.
    let apart = wanted.transpose() * rotation;
    let error = Vector3::new(
        0.5 * (apart[(2, 1)] - apart[(1, 2)]),
        0.5 * (apart[(0, 2)] - apart[(2, 0)]),
        0.5 * (apart[(1, 0)] - apart[(0, 1)]),
    );
    let error_rate = estimate.rates - Vector3::new(0.0, 0.0, -target.yaw_rate);
    let gains = parameters.geometric.attitude;
    let turn = -(error * gains.p + error_rate * gains.d);
    let inertia = parameters.inertia;
    let gyroscopic = estimate.rates.cross(&inertia.component_mul(&estimate.rates));

    let upwards = Vector3::new(rotation[(0, 2)], rotation[(1, 2)], rotation[(2, 2)]);
    Wrench { thrust: force.dot(&upwards), torque: inertia.component_mul(&turn) + gyroscopic }
}

/// The force that is wanted of the motors, in the inertial frame, N.
#[function]
fn push(parameters: &Parameters, estimate: &Estimate, target: &Target) -> Vector3<f64> {
    let weight = Vector3::new(0.0, 0.0, parameters.mass * GRAVITY);
    if target.take_off {
        return weight * (1.0 + parameters.takeoff_gain);
    }
    let gains = parameters.geometric.place;
    let error = target.position - estimate.position;
    let error_rate = target.velocity - estimate.velocity;
    let climb = Vector3::new(0.0, 0.0, target.climb_acceleration);
    weight + (error * gains.p + error_rate * gains.d + climb) * parameters.mass
}
