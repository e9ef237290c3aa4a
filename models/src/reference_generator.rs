//! Target of the aircraft in each period (thesis, §6.1, reference generator): take-off, trajectory or sticks, landing.
//!
//! It knows commands and position, not the control law.

use crate::geometry::wrapped;
use crate::receiver::{Mode, Orders, Sticks};
use crate::shaper::{Shaper, Shaping};
use crate::signals::{Estimate, Target};
use crate::trajectory::SetPoint;
use bessemer::prelude::*;

/// Height above which the aircraft is airborne, m.
#[requirement("HLR-05")]
#[data]
const GROUND_CLEARANCE: f64 = 0.1;

/// Phase of the flight.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Phase {
    /// On the ground with motors off.
    #[default]
    Ready,
    /// Climbing without height control.
    TakeOff,
    /// Following the trajectory or the sticks.
    Flight,
    /// Descending to the ground.
    Landing,
    /// Landed, stopped or disarmed: the motors stay off until initialisation or the next arming.
    Over,
    /// Holding the last setpoint, since the link is lost.
    Hold,
}

/// Parameters of take-off, landing and timeouts.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Course {
    /// Control period, s.
    pub period: f64,
    /// Duration of the take-off climb, s.
    pub takeoff_duration: f64,
    /// Landing rate (K_landing of the thesis' eq. (3.20)), m/s.
    pub landing_rate: f64,
    /// Age at which the sticks are treated as centred, s.
    pub stick_timeout: f64,
    /// Largest height that sticks can ask for, m.
    pub ceiling: f64,
    /// Limits of the set point.
    pub shaping: Shaping,
    /// Largest rate of the yaw setpoint, rad/s: a step would take thrust from the height control.
    pub yaw_rate_limit: f64,
    /// Time without the ground station's heartbeat after which the aircraft holds its position, s.
    pub hold_timeout: f64,
    /// Time without the ground station's heartbeat after which the aircraft lands, s.
    pub landing_timeout: f64,
}

#[data]
impl Course {
    /// Returns the parameters of the Mambo. The thesis uses the sample time as K_landing, with which a landing takes
    /// 200 s.
    #[requirement("HLR-01", "HLR-09", "HLR-14", "HLR-17", "HLR-31")]
    pub fn mambo() -> Course {
        Course {
            period: 0.005,
            takeoff_duration: 1.0,
            landing_rate: 0.25,
            stick_timeout: 0.5,
            ceiling: 2.5,
            shaping: Shaping::room(),
            yaw_rate_limit: 1.0,
            hold_timeout: 1.0,
            landing_timeout: 6.0,
        }
    }
}

/// Output of the reference generator.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reference {
    /// Target of the aircraft.
    pub target: Target,
    /// Phase of the flight.
    pub phase: Phase,
    /// True if the motors may turn.
    pub motors: bool,
    /// Time since take-off, s.
    pub time: f64,
}

/// The reference generator.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReferenceGenerator {
    /// Phase of the flight.
    pub phase: Phase,
    /// Time since the take-off began, s.
    pub time: f64,
    /// Time since the landing began, s.
    pub landing: f64,
    /// Last setpoint.
    pub wanted: SetPoint,
    /// Set point after shaping.
    pub shaper: Shaper,
    /// Yaw setpoint after rate limiting, rad.
    pub yaw: f64,
    /// True if the aircraft has left the ground.
    pub airborne: bool,
}

#[component]
impl ReferenceGenerator {
    /// Advances one period and returns the reference. `landed`: touch-down was detected. `degraded`: the aircraft must
    /// land, whatever was commanded.
    #[requirement("HLR-05", "HLR-14")]
    #[entry(infallible)]
    pub fn step(
        &mut self,
        course: &Course,
        orders: &Orders,
        estimate: &Estimate,
        landed: bool,
        degraded: bool,
    ) -> Reference {
        if self.phase == Phase::Ready {
            self.wanted = orders.trajectory.at(0.0);
        }
        self.change_phase(course, orders, estimate, landed, degraded);
        self.airborne = self.airborne || estimate.position.z > GROUND_CLEARANCE;
        let mut target = Target::idle();
        target.grounded = !self.airborne;
        match self.phase {
            Phase::Ready | Phase::Over | Phase::Hold => {}
            Phase::TakeOff => target.take_off = true,
            Phase::Flight if orders.mode == Mode::Manual => {
                self.follow_sticks(course, orders, estimate, &mut target);
            }
            Phase::Flight => self.wanted = orders.trajectory.at(self.time),
            Phase::Landing => {
                // (3.20): descends from the last height setpoint, continuing below the ground.
                self.landing += course.period;
                target.land = true;
                target.velocity.z = -course.landing_rate;
            }
        }
        self.shape(course, estimate, &mut target);
        target.position.z -= course.landing_rate * self.landing;
        self.turn(course, estimate, &mut target);

        let motors = self.is_flying();
        if motors {
            self.time += course.period;
        }
        Reference { target, phase: self.phase, motors, time: self.time }
    }

    /// Stops the motors permanently.
    #[requirement("HLR-37")]
    #[entry(infallible)]
    pub fn end(&mut self) {
        self.phase = Phase::Over;
    }

    /// Returns true if the motors turn.
    #[entry(infallible)]
    pub fn is_flying(&self) -> bool {
        self.phase != Phase::Ready && self.phase != Phase::Over
    }

    /// Changes the phase of the flight.
    ///
    /// An aircraft that is lighter or stronger than it is believed to be takes off faster: the closed loop
    /// takes over at half the height that is wanted, if that comes before the end of the takeoff_duration.
    #[requirement("HLR-01", "HLR-17", "HLR-24")]
    fn change_phase(
        &mut self,
        course: &Course,
        orders: &Orders,
        estimate: &Estimate,
        landed: bool,
        degraded: bool,
    ) {
        let aloft = self.phase == Phase::Flight || self.phase == Phase::Hold;
        if degraded && (self.phase == Phase::TakeOff || aloft) {
            self.stop(course, estimate);
        }
        let alone = orders.watched && orders.silence > course.hold_timeout;
        let link_lost = orders.watched && orders.silence > course.landing_timeout;
        let land = orders.land || degraded || link_lost;
        let off = estimate.position.z > 0.5 * self.wanted.position.z;
        self.phase = match self.phase {
            Phase::Ready if orders.take_off && !land => Phase::TakeOff,
            Phase::TakeOff | Phase::Flight | Phase::Hold if land => Phase::Landing,
            Phase::Flight if alone => Phase::Hold,
            Phase::Hold if !alone => Phase::Flight,
            Phase::TakeOff if self.time >= course.takeoff_duration || off => Phase::Flight,
            Phase::Landing if landed => Phase::Over,
            same => same,
        };
    }

    /// Wants the aircraft to stop where it is. A shaped set point stops gently, since the aircraft may have no attitude but
    /// an estimate.
    fn stop(&mut self, course: &Course, estimate: &Estimate) {
        self.wanted.position = estimate.position;
        self.wanted.yaw = self.yaw;
        if course.shaping.is_active {
            let along = Vector3::new(estimate.velocity.x, estimate.velocity.y, 0.0);
            self.shaper.begin(&course.shaping, &estimate.position, &along);
            self.wanted.position = self.shaper.ramp;
        }
    }

    /// Shapes the set point. It follows the aircraft in the take-off, and rests at it while a pilot flies.
    fn shape(&mut self, course: &Course, estimate: &Estimate, target: &mut Target) {
        let shaping = &course.shaping;
        target.position = self.wanted.position;
        if !self.airborne || self.phase == Phase::TakeOff {
            let climb = Vector3::new(0.0, 0.0, estimate.velocity.z);
            self.shaper.begin(shaping, &estimate.position, &climb);
            if shaping.is_active {
                target.position.x = estimate.position.x;
                target.position.y = estimate.position.y;
            }
        } else if target.manual {
            self.shaper.rest(&self.wanted.position);
        } else {
            let shaped = self.shaper.step(shaping, course.period, &self.wanted.position);
            target.position = shaped.position;
            target.velocity += shaped.velocity;
            target.acceleration = Vector2::new(shaped.acceleration.x, shaped.acceleration.y);
            target.climb_acceleration = shaped.acceleration.z;
        }
    }

    /// Moves the yaw setpoint to the requested yaw; until the aircraft is airborne it is the measured yaw.
    #[requirement("HLR-09")]
    fn turn(&mut self, course: &Course, estimate: &Estimate, target: &mut Target) {
        if !self.airborne {
            self.yaw = estimate.angles.z;
        }
        // The shorter direction; the yaw itself may exceed half a turn.
        let left = wrapped(self.wanted.yaw - self.yaw);
        let most = course.yaw_rate_limit * course.period;
        if !self.airborne {
            target.yaw_rate = 0.0;
        } else if !target.manual && left.abs() > most {
            target.yaw_rate = course.yaw_rate_limit.copysign(left);
            self.yaw += most.copysign(left);
        } else {
            self.yaw += left;
        }
        target.yaw = self.yaw;
    }

    /// Follows the sticks in tilt, yaw rate and climb rate, and integrates height and yaw.
    #[requirement("HLR-31")]
    fn follow_sticks(
        &mut self,
        course: &Course,
        orders: &Orders,
        estimate: &Estimate,
        target: &mut Target,
    ) {
        let mut sticks = orders.sticks;
        if orders.sticks_age > course.stick_timeout {
            sticks = Sticks::centred();
        }
        target.manual = true;
        target.lean = sticks.lean;
        target.yaw_rate = sticks.yaw_rate;
        target.velocity.z = sticks.climb;
        self.wanted.yaw = self.yaw + sticks.yaw_rate * course.period;
        let height = self.wanted.position.z + sticks.climb * course.period;
        self.wanted.position.x = estimate.position.x;
        self.wanted.position.y = estimate.position.y;
        self.wanted.position.z = height.max(0.0).min(course.ceiling);
    }
}
