//! Where the aircraft is to be at each moment (thesis, §6.1, reference generator): take-off, the
//! trajectory or the sticks, landing.
//!
//! Knows what was asked for and where the aircraft is, not how it gets to where it is wanted.

use crate::geometry::wrapped;
use crate::receiver::{Mode, Orders, Sticks};
use crate::signals::{Estimate, Target};
use crate::trajectory::SetPoint;
use bessemer::prelude::*;

/// Height above which the aircraft has left the ground, m.
#[data]
const CLEAR: f64 = 0.1;

/// Which part of the flight it is.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Phase {
    /// On the ground, the motors off.
    #[default]
    Ready,
    /// Climbing without minding the height.
    TakeOff,
    /// Following the trajectory or the sticks.
    Flight,
    /// Sinking to the ground.
    Landing,
    /// On the ground again, or stopped: the motors stay off until `init`, or until it is armed again.
    Over,
    /// Staying where it was wanted last, since the ground is not heard any more.
    Hold,
}

/// How a flight begins and ends.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Course {
    /// Control period, s.
    pub period: f64,
    /// How long the take-off climbs, s.
    pub burn: f64,
    /// How fast the landing sinks (K_landing of the thesis' eq. (3.20)), m/s.
    pub sink: f64,
    /// How old the sticks may be before they count as let go, s.
    pub patience: f64,
    /// Largest height that sticks can ask for, m.
    pub ceiling: f64,
    /// How fast the wanted yaw goes to that of a set point, rad/s: a step would take from the height what
    /// the motors need for it.
    pub turn: f64,
    /// How long the ground may be silent, once it has said that it will not be, before the aircraft stays
    /// where it is, s.
    pub silence: f64,
    /// The same before it lands, s.
    pub farewell: f64,
}

#[data]
impl Course {
    /// The Mambo's. The thesis takes the sample time for K_landing, which would take 200 s to land.
    pub fn mambo() -> Course {
        Course {
            period: 0.005,
            burn: 1.0,
            sink: 0.25,
            patience: 0.5,
            ceiling: 2.5,
            turn: 1.0,
            silence: 1.0,
            farewell: 6.0,
        }
    }
}

/// What the reference generator says.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Reference {
    /// Where the aircraft is wanted.
    pub target: Target,
    /// Which part of the flight it is.
    pub phase: Phase,
    /// Whether the motors may turn.
    pub motors: bool,
    /// Time since take-off, s.
    pub time: f64,
}

/// The reference generator.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReferenceGenerator {
    /// Which part of the flight it is.
    pub phase: Phase,
    /// Time since the take-off began, s.
    pub time: f64,
    /// Time since the landing began, s.
    pub landing: f64,
    /// Where the aircraft was wanted last.
    pub wanted: SetPoint,
    /// The yaw on its way to the wanted one, rad.
    pub yaw: f64,
    /// Whether the aircraft has left the ground.
    pub airborne: bool,
}

#[component]
impl ReferenceGenerator {
    /// One period. `landed`: whether the landing aircraft has touched down; `limp`: whether it had better
    /// land, whatever was ordered.
    #[entry(infallible)]
    pub fn step(
        &mut self,
        course: &Course,
        orders: &Orders,
        estimate: &Estimate,
        landed: bool,
        limp: bool,
    ) -> Reference {
        if self.phase == Phase::Ready {
            self.wanted = orders.trajectory.at(0.0);
        }
        self.change_phase(course, orders, estimate, landed, limp);
        self.airborne = self.airborne || estimate.position.z > CLEAR;
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
                // (3.20): from the last height that was wanted, down and on into the ground.
                self.landing += course.period;
                target.land = true;
                target.velocity.z = -course.sink;
            }
        }
        target.position = self.wanted.position;
        target.position.z -= course.sink * self.landing;
        self.turn(course, estimate, &mut target);

        let motors = self.is_flying();
        if motors {
            self.time += course.period;
        }
        Reference { target, phase: self.phase, motors, time: self.time }
    }

    /// Stops the motors for good.
    #[entry(infallible)]
    pub fn end(&mut self) {
        self.phase = Phase::Over;
    }

    /// Whether the motors turn.
    #[entry(infallible)]
    pub fn is_flying(&self) -> bool {
        self.phase != Phase::Ready && self.phase != Phase::Over
    }

    /// From one part of the flight to the next.
    ///
    /// An aircraft that is lighter or stronger than it is believed to be takes off faster: the closed loop
    /// takes over at half the height that is wanted, if that comes before the end of the burn.
    fn change_phase(
        &mut self,
        course: &Course,
        orders: &Orders,
        estimate: &Estimate,
        landed: bool,
        limp: bool,
    ) {
        let aloft = self.phase == Phase::Flight || self.phase == Phase::Hold;
        if limp && (self.phase == Phase::TakeOff || aloft) {
            self.wanted.position = estimate.position;
            self.wanted.yaw = self.yaw;
        }
        let alone = orders.watched && orders.silence > course.silence;
        let left = orders.watched && orders.silence > course.farewell;
        let land = orders.land || limp || left;
        let off = estimate.position.z > 0.5 * self.wanted.position.z;
        self.phase = match self.phase {
            Phase::Ready if orders.take_off && !land => Phase::TakeOff,
            Phase::TakeOff | Phase::Flight | Phase::Hold if land => Phase::Landing,
            Phase::Flight if alone => Phase::Hold,
            Phase::Hold if !alone => Phase::Flight,
            Phase::TakeOff if self.time >= course.burn || off => Phase::Flight,
            Phase::Landing if landed => Phase::Over,
            same => same,
        };
    }

    /// Turns to the wanted yaw, from that in which the aircraft stands until it has left the ground.
    fn turn(&mut self, course: &Course, estimate: &Estimate, target: &mut Target) {
        if !self.airborne {
            self.yaw = estimate.angles.z;
        }
        // The short way round: the yaw itself goes on beyond half a turn.
        let left = wrapped(self.wanted.yaw - self.yaw);
        let most = course.turn * course.period;
        if !self.airborne {
            target.yaw_rate = 0.0;
        } else if !target.manual && left.abs() > most {
            target.yaw_rate = course.turn.copysign(left);
            self.yaw += most.copysign(left);
        } else {
            self.yaw += left;
        }
        target.yaw = self.yaw;
    }

    /// Leans and turns as the sticks ask; the height and the yaw that they change are held.
    fn follow_sticks(
        &mut self,
        course: &Course,
        orders: &Orders,
        estimate: &Estimate,
        target: &mut Target,
    ) {
        let mut sticks = orders.sticks;
        if orders.sticks_age > course.patience {
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
