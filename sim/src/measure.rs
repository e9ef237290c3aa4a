//! Figures of a flight: errors, overshoot, settling, touch-down, commands.
//!
//! All of them are measured on the true state, not on the software's estimate.

use crate::voyage::{Moment, Voyage};
use models::airframe::GRAVITY;
use models::geometry::wrapped;
use models::{Airframe, Alarm, Phase};
use nalgebra::Vector2;

/// Error of height below which the height counts as settled, m.
pub const CLOSE: f64 = 0.05;

/// A horizontal step of the set point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Set point before the step, m.
    pub start: Vector2<f64>,
    /// Set point after the step, m.
    pub end: Vector2<f64>,
}

impl Step {
    /// Returns the share of the step that the aircraft has covered, along its direction.
    fn way(&self, moment: &Moment) -> f64 {
        let whole = self.end - self.start;
        (moment.state.position.xy() - self.start).dot(&whole) / whole.norm_squared()
    }
}

impl Voyage {
    /// Returns the periods between two times, s.
    pub fn between(&self, from: f64, to: f64) -> impl Iterator<Item = &Moment> {
        self.moments.iter().filter(move |moment| from <= moment.time && moment.time < to)
    }

    /// Largest error of height between two times, m.
    pub fn height_error(&self, from: f64, to: f64) -> f64 {
        self.worst(from, to, |moment| wanted(moment).z - moment.state.position.z)
    }

    /// Returns the largest distance from the target in the plane between two times, m.
    pub fn plane_error(&self, from: f64, to: f64) -> f64 {
        self.worst(from, to, |moment| (wanted(moment) - moment.state.position).xy().norm())
    }

    /// Largest error of yaw between two times, rad.
    pub fn yaw_error(&self, from: f64, to: f64) -> f64 {
        self.worst(from, to, |moment| {
            wrapped(moment.outputs.reference.target.yaw - moment.state.angles.z)
        })
    }

    /// Returns the overshoot of the height beyond `goal` between two times, m.
    pub fn overshoot(&self, from: f64, to: f64, goal: f64) -> f64 {
        self.between(from, to).map(|moment| moment.state.position.z - goal).fold(0.0, f64::max)
    }

    /// Returns the time after `from` from which on the height stays within [`CLOSE`] of `goal` until `to`, s.
    pub fn settling(&self, from: f64, to: f64, goal: f64) -> f64 {
        let away = |moment: &&Moment| (moment.state.position.z - goal).abs() > CLOSE;
        self.between(from, to).filter(away).last().map_or(0.0, |moment| moment.time - from)
    }

    /// Returns the overshoot of a horizontal step between two times, as a fraction of its length.
    pub fn step_overshoot(&self, from: f64, to: f64, step: &Step) -> f64 {
        self.between(from, to).map(|moment| step.way(moment) - 1.0).fold(0.0, f64::max)
    }

    /// Returns the time after `from` from which on the aircraft stays within 5 % of the end of a horizontal step until
    /// `to`, s.
    pub fn step_settling(&self, from: f64, to: f64, step: &Step) -> f64 {
        let near = 0.05 * (step.end - step.start).norm();
        let away = |moment: &&Moment| (moment.state.position.xy() - step.end).norm() > near;
        self.between(from, to).filter(away).last().map_or(0.0, |moment| moment.time - from)
    }

    /// Returns the largest tilt between two times, °.
    pub fn tilt(&self, from: f64, to: f64) -> f64 {
        let upright = |it: &Moment| it.state.angles.x.cos() * it.state.angles.y.cos();
        self.worst(from, to, |moment| upright(moment).acos().to_degrees())
    }

    /// Returns the largest speed of touch-down, m/s; infinite if the aircraft is still in the air at the end.
    pub fn touch_down(&self) -> f64 {
        let grounded = self.moments.last().is_some_and(|moment| moment.state.position.z <= 0.0);
        let hardest = self.moments.iter().map(|moment| moment.impact).fold(0.0, f64::max);
        if grounded { hardest } else { f64::INFINITY }
    }

    /// Returns true if the flight ended on the ground with the motors off and no alarm.
    pub fn ended_well(&self) -> bool {
        self.moments.last().is_some_and(|moment| {
            let outputs = &moment.outputs;
            let off = outputs.command.motors.amax() == 0.0;
            off && outputs.reference.phase == Phase::Over && outputs.alarm == Alarm::Clear
        })
    }

    /// Returns the first alarm and its time, s.
    pub fn alarm(&self) -> Option<(f64, Alarm)> {
        let raised = self.moments.iter().find(|moment| moment.outputs.alarm != Alarm::Clear);
        raised.map(|moment| (moment.time, moment.outputs.alarm))
    }

    /// Mean of the closed loop's command over motors and time, rad/s.
    pub fn closed_loop(&self, from: f64, to: f64) -> f64 {
        self.mean(from, to, |moment| mean_of(moment.outputs.command.closed_loop.as_slice()))
    }

    /// Returns the mean commanded speed over motors and time, rad/s.
    pub fn commanded(&self, from: f64, to: f64) -> f64 {
        self.mean(from, to, |moment| mean_of(moment.outputs.command.speeds.as_slice()))
    }

    /// Error of the closed loop's command under a feed-forward of the given gain (thesis, eq. (7.2)):
    /// its mean against `(1 − gain) × hover`, as a fraction.
    pub fn command_error(&self, from: f64, to: f64, gain: f64, hover: f64) -> f64 {
        let planned = (1.0 - gain) * hover;
        (planned - self.closed_loop(from, to)).abs() / planned
    }

    fn worst(&self, from: f64, to: f64, error: impl Fn(&Moment) -> f64) -> f64 {
        let larger = |so_far: f64, value: f64| {
            if value.is_nan() { f64::INFINITY } else { so_far.max(value.abs()) }
        };
        self.between(from, to).map(error).fold(0.0, larger)
    }

    fn mean(&self, from: f64, to: f64, value: impl Fn(&Moment) -> f64) -> f64 {
        let values: Vec<f64> = self.between(from, to).map(value).collect();
        values.iter().sum::<f64>() / values.len() as f64
    }
}

/// Returns the mean magnitude over the existing motors; the others are 0.
fn mean_of(motors: &[f64]) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0_f64);
    for motor in motors.iter().filter(|motor| **motor != 0.0) {
        sum += motor.abs();
        count += 1.0;
    }
    sum / count.max(1.0)
}

fn wanted(moment: &Moment) -> nalgebra::Vector3<f64> {
    moment.outputs.reference.target.position
}

/// The speed at which a motor carries its share of the weight, rad/s (thesis, eq. (4.16)), as the mean over
/// the motors.
pub fn hover_speed(airframe: &Airframe) -> f64 {
    let share = airframe.mass * GRAVITY / airframe.motors as f64;
    let factors = airframe.thrust_factors();
    let speeds = factors.iter().take(airframe.motors).map(|factor| (share / factor).sqrt());
    speeds.sum::<f64>() / airframe.motors as f64
}
