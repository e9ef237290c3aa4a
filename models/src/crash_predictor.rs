//! Crash prediction (thesis, §6.1): limits on the present state, on the state extrapolated over a horizon, and on the
//! age of the measurements.
//!
//! It checks the state, not the cause. An alarm, once raised, stays until initialisation: the motors stop.

use crate::airframe::GRAVITY;
use crate::estimator::Ages;
use crate::geometry::Orientation;
use crate::signals::Estimate;
use bessemer::prelude::*;

/// Number of consecutive periods in which a limit must be exceeded before the alarm is raised.
#[requirement("HLR-35")]
#[data]
const CONFIRMATION_PERIODS: u32 = 3;

/// Height below which an aircraft without attitude information continues its landing, m.
#[requirement("HLR-25")]
#[data]
const LANDING_HEIGHT: f64 = 0.2;

/// Cause of an alarm.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Alarm {
    /// No alarm.
    #[default]
    Clear,
    /// The ground station commanded the motors to stop.
    Commanded,
    /// The state is not a number.
    Undefined,
    /// The processor's clock does not advance by one period per period.
    Clock,
    /// A part of the state has not been measured for too long.
    Unmeasured,
    /// The aircraft tilts too far, or will.
    Tilt,
    /// The aircraft turns too fast.
    Spin,
    /// The aircraft moves too fast, or will.
    Speed,
    /// The aircraft is too high, or will be.
    Height,
    /// The aircraft is too far from the start, or will be.
    Position,
    /// The aircraft will hit the ground too hard.
    Impact,
}

/// Limits of the crash predictor.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// Largest tilt, rad.
    pub tilt: f64,
    /// Fastest turn about the body's x and y, and about its z, rad/s.
    pub rates: Vector2<f64>,
    /// Largest speed, m/s.
    pub speed: f64,
    /// Largest height, m.
    pub ceiling: f64,
    /// Largest distance from the start along x and along y, m.
    pub reach: f64,
    /// Fastest touch-down, m/s.
    pub impact: f64,
    /// Longest time without a measurement of height or horizontal motion, s: as long as dead reckoning is usable.
    pub dead_reckoning_timeout: f64,
    /// Longest time without an attitude source, s: the camera is the only one while gyroscope and Vicon are lost.
    pub attitude_timeout: f64,
    /// Extrapolation horizon, s.
    pub horizon: f64,
    /// True if an alarm stops the motors; false to monitor only.
    pub armed: bool,
}

#[data]
impl Limits {
    /// Limits for flights in a room.
    #[requirement("HLR-35", "HLR-36")]
    pub fn room() -> Limits {
        Limits {
            tilt: 0.9,
            rates: Vector2::new(12.0, 12.0),
            speed: 4.0,
            ceiling: 4.0,
            reach: 4.0,
            impact: 0.7,
            dead_reckoning_timeout: 20.0,
            attitude_timeout: 0.1,
            horizon: 0.1,
            armed: true,
        }
    }
}

/// The crash predictor.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CrashPredictor {
    /// The first alarm raised.
    pub alarm: Alarm,
    /// Number of consecutive periods in which a limit was exceeded.
    pub violations: u32,
}

#[component]
impl CrashPredictor {
    /// Checks the limits for one period and returns the alarm. Only a flying aircraft is checked. `orientation` is the
    /// estimated one, `climb` the vertical acceleration, m/s².
    #[requirement("HLR-35", "HLR-37", "HLR-38")]
    #[entry(infallible)]
    pub fn step(
        &mut self,
        limits: &Limits,
        flying: bool,
        estimate: &Estimate,
        orientation: &Orientation,
        ages: &Ages,
        climb: f64,
    ) -> Alarm {
        if flying && limits.armed && self.alarm == Alarm::Clear {
            let found = CrashPredictor::find(limits, estimate, orientation, ages, climb);
            self.violations = self.violations.saturating_add(1);
            if found == Alarm::Clear {
                self.violations = 0;
            }
            if found == Alarm::Undefined || self.violations >= CONFIRMATION_PERIODS {
                self.alarm = found;
            }
        }
        self.alarm
    }

    /// Raises an alarm that does not depend on the state.
    #[requirement("HLR-37")]
    #[entry(infallible)]
    pub fn raise(&mut self, alarm: Alarm) {
        if self.alarm == Alarm::Clear {
            self.alarm = alarm;
        }
    }

    /// Returns the limit that is exceeded now or within the horizon.
    #[requirement("HLR-25", "HLR-35", "HLR-37")]
    fn find(
        limits: &Limits,
        now: &Estimate,
        orientation: &Orientation,
        ages: &Ages,
        climb: f64,
    ) -> Alarm {
        let sum = now.position.norm() + now.angles.norm() + now.velocity.norm() + now.rates.norm();
        if !sum.is_finite() {
            return Alarm::Undefined;
        }
        let attitude_unmeasured =
            ages.inertial > limits.attitude_timeout && ages.vicon > limits.attitude_timeout;
        let attitude_lost = attitude_unmeasured
            && ages.plane > limits.attitude_timeout
            && now.position.z > LANDING_HEIGHT;
        if attitude_lost
            || ages.height > limits.dead_reckoning_timeout
            || ages.plane > limits.dead_reckoning_timeout
        {
            return Alarm::Unmeasured;
        }
        let mut horizon = limits.horizon;
        if attitude_unmeasured {
            // Predicted rates are uncertain, and so is the extrapolation.
            horizon *= 0.3;
        }
        let across = now.rates.x.hypot(now.rates.y);
        if across > limits.rates.x || now.rates.z.abs() > limits.rates.y {
            return Alarm::Spin;
        }
        let ahead = now.angles + orientation.angle_rates(&now.rates) * horizon;
        let upright = limits.tilt.cos();
        let tilted = orientation.c1 * orientation.c2 < upright;
        // The cosine of the angle between the body's z and the inertial frame's.
        if tilted || ahead.x.cos() * ahead.y.cos() < upright {
            return Alarm::Tilt;
        }
        CrashPredictor::find_in_motion(limits, now, orientation, climb, horizon)
    }

    /// Returns the limit of speed or position that is exceeded now or within the horizon.
    #[requirement("HLR-35", "HLR-36")]
    fn find_in_motion(
        limits: &Limits,
        now: &Estimate,
        orientation: &Orientation,
        climb: f64,
        horizon: f64,
    ) -> Alarm {
        let place = now.position + now.velocity * horizon;
        // Horizontally, the thrust that carries the weight accelerates the aircraft in the direction of the tilt.
        let direction = orientation.thrust_direction();
        let pull = Vector3::new(direction.x, direction.y, 0.0) * GRAVITY;
        let velocity = now.velocity + pull * horizon;
        if now.velocity.norm() > limits.speed || velocity.norm() > limits.speed {
            return Alarm::Speed;
        }
        if now.position.z > limits.ceiling || place.z > limits.ceiling {
            return Alarm::Height;
        }
        if place.x.abs() > limits.reach || place.y.abs() > limits.reach {
            return Alarm::Position;
        }
        let gained = climb * horizon;
        let low = place.z + 0.5 * gained * horizon;
        if low < 0.0 && now.velocity.z + gained < -limits.impact {
            return Alarm::Impact;
        }
        Alarm::Clear
    }
}
