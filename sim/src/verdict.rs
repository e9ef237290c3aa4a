//! Verdict on a flight: whether it settled after each manoeuvre, resisted gusts, and landed.
//!
//! Knows targets and the true state, but not the pilot.

use crate::flight::{Flight, Step};
use crate::mission::{Gust, Mission};
use std::fmt;

/// Largest distance to the target, and the time for which it must hold before the next manoeuvre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Largest error of height, m.
    pub height: f64,
    /// Largest distance from the target in the plane, m.
    pub place: f64,
    /// Largest error of yaw, rad.
    pub yaw: f64,
    /// Time for which the errors must stay within these limits, s.
    pub window: f64,
    /// Fastest rotation about another axis than the gust's, during a gust, rad/s.
    pub cross_rate: f64,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self { height: 0.01, place: 0.02, yaw: 1f64.to_radians(), window: 0.5, cross_rate: 0.05 }
    }
}

/// Largest errors over a window.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Error of height, m.
    pub height: f64,
    /// Distance from the target in the plane, m.
    pub place: f64,
    /// Error of yaw, rad.
    pub yaw: f64,
}

impl Errors {
    /// Returns the largest errors of these steps.
    pub fn over<'a>(steps: impl Iterator<Item = &'a Step>) -> Self {
        steps.fold(Self::default(), |so_far, step| {
            let error = step.target.position - step.state.position;
            Self {
                height: worst(so_far.height, error.z),
                place: worst(so_far.place, error.xy().norm()),
                yaw: worst(so_far.yaw, step.target.yaw - step.state.angles.z),
            }
        })
    }
}

/// Returns the larger magnitude; NaN counts as infinite.
fn worst(so_far: f64, value: f64) -> f64 {
    if value.is_nan() { f64::INFINITY } else { so_far.max(value.abs()) }
}

/// Errors just before the next manoeuvre.
#[derive(Clone, Debug, PartialEq)]
pub struct Settled {
    /// The preceding manoeuvre.
    pub manoeuvre: &'static str,
    /// Time of the next manoeuvre, s.
    pub by: f64,
    /// Largest errors over the window before that time.
    pub errors: Errors,
}

/// Fault of a flight.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// A manoeuvre did not settle in time.
    Unsettled(Settled),
    /// A gust about one axis turned the aircraft about another.
    Turned {
        /// Name of the gust.
        gust: &'static str,
        /// Rate about another axis, rad/s.
        rate: f64,
    },
    /// The aircraft did not land at the target, or its motors still run.
    NotLanded {
        /// Height at the end, m.
        height: f64,
        /// Distance from the target in the plane at the end, m.
        place: f64,
        /// Largest motor command at the end.
        command: f64,
    },
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Unsettled(Settled { manoeuvre, by, errors }) => write!(
                f,
                "{manoeuvre}: not settled by {by} s: {:.1} mm in height, {:.1} mm in the plane, {:.2}° in yaw",
                1e3 * errors.height,
                1e3 * errors.place,
                errors.yaw.to_degrees(),
            ),
            Fault::Turned { gust, rate } => {
                write!(f, "{gust}: turned at {rate:.3} rad/s about another axis")
            }
            Fault::NotLanded { height, place, command } => {
                write!(f, "not landed: {height:.3} m up, {place:.3} m away, motors at {command:.0}",)
            }
        }
    }
}

/// Returns the errors at the start of each manoeuvre but the first.
pub fn settled(flight: &Flight, mission: &Mission, window: f64) -> Vec<Settled> {
    let pairs = mission.manoeuvres.iter().zip(mission.manoeuvres.iter().skip(1));
    pairs
        .map(|((_, before), (by, _))| {
            let by = *by;
            let inside = |step: &&Step| by - window <= step.time && step.time < by;
            Settled {
                manoeuvre: before.name,
                by,
                errors: Errors::over(flight.steps.iter().filter(inside)),
            }
        })
        .collect()
}

/// Returns all faults of a flight.
pub fn judge(flight: &Flight, mission: &Mission, tolerance: &Tolerance) -> Vec<Fault> {
    let mut faults: Vec<Fault> = settled(flight, mission, tolerance.window)
        .into_iter()
        .filter(|settled| !tolerance.allows(&settled.errors))
        .map(Fault::Unsettled)
        .collect();
    faults.extend(gust_faults(flight, mission, tolerance));
    faults.extend(landing_fault(flight, tolerance));
    faults
}

/// Returns the fastest rotation about another axis than the gust's, during the gust, rad/s.
pub fn cross_rate(flight: &Flight, gust: &Gust) -> f64 {
    let axis = gust.torque.normalize();
    let blowing = |step: &&Step| gust.begins <= step.time && step.time <= gust.ends();
    let across = |step: &Step| step.state.rates.cross(&axis).norm();
    flight.steps.iter().filter(blowing).map(across).fold(0.0, worst)
}

fn gust_faults(flight: &Flight, mission: &Mission, tolerance: &Tolerance) -> Vec<Fault> {
    let fault = |gust: &Gust| {
        let rate = cross_rate(flight, gust);
        let turned = rate > tolerance.cross_rate;
        turned.then_some(Fault::Turned { gust: gust.name, rate })
    };
    mission.gusts.iter().filter_map(fault).collect()
}

fn landing_fault(flight: &Flight, tolerance: &Tolerance) -> Option<Fault> {
    let last = flight.steps.last()?;
    let height = flight.end.position.z;
    let place = (last.target.position - flight.end.position).xy().norm();
    let command = last.command.motors.max();
    let landed = height == 0.0 && place < tolerance.place && command == 0.0;
    (!landed).then_some(Fault::NotLanded { height, place, command })
}

impl Tolerance {
    /// Returns true if the errors are within the tolerance.
    pub fn allows(&self, errors: &Errors) -> bool {
        errors.height < self.height && errors.place < self.place && errors.yaw < self.yaw
    }
}

/// A motor at one of its limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Saturation {
    /// Index of the motor, counted from 0.
    pub motor: usize,
    /// True at its upper limit, false at its lower.
    pub upper: bool,
    /// First time at the limit, s.
    pub first: f64,
    /// Number of control periods at the limit.
    pub periods: usize,
}

/// Returns the motors that reached their limits before the landing.
pub fn saturations(flight: &Flight, largest_command: f64) -> Vec<Saturation> {
    let mut found = Vec::new();
    for motor in 0..4 {
        for (upper, limit) in [(true, largest_command), (false, 0.0)] {
            let at_limit = |step: &&Step| !step.target.land && step.command.motors[motor] == limit;
            let mut steps = flight.steps.iter().filter(at_limit).peekable();
            if let Some(first) = steps.peek().map(|step| step.time) {
                found.push(Saturation { motor, upper, first, periods: steps.count() });
            }
        }
    }
    found
}
