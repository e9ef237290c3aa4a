//! The whole onboard software (thesis, ch. 6): everything that happens in one period, in its order.
//!
//! Composes the components and nothing else. Receiver, estimator, reference, controller, mixer and sender
//! work in each period, at 200 Hz; the sensors bring what is new at their own rates, and the logger
//! writes at its own.

use crate::airframe::Airframe;
use crate::calibration::{Calibration, Readings};
use crate::clock_monitor::ClockMonitor;
use crate::controller::Controller;
use crate::crash_predictor::{Alarm, CrashPredictor, Limits};
use crate::estimator::{Ages, Estimator, Sensors};
use crate::expectation::Push;
use crate::feed_forward::{Injection, compensation};
use crate::logger::{Choice, Logger};
use crate::packet::Packet;
use crate::parameters::Parameters;
use crate::receiver::{Mode, Receiver};
use crate::reference_generator::{Course, Reference, ReferenceGenerator};
use crate::sender::Sender;
use crate::signals::{Command, Estimate};
use crate::trajectory::Space;
use bessemer::prelude::*;

/// Everything that can be set before a flight.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settings {
    /// The aircraft as it is believed to be: for the feed-forward.
    pub airframe: Airframe,
    /// The sensors' scales.
    pub calibration: Calibration,
    /// The sensors' noise.
    pub sensors: Sensors,
    /// Where trajectories may lead.
    pub space: Space,
    /// How flights begin and end.
    pub course: Course,
    /// When to stop the motors.
    pub limits: Limits,
    /// The closed loop.
    pub parameters: Parameters,
    /// The feed-forward.
    pub injection: Injection,
    /// What to write down.
    pub choice: Choice,
}

#[data]
impl Settings {
    /// The Mambo, in a room.
    pub fn mambo() -> Settings {
        Settings {
            airframe: Airframe::mambo(),
            calibration: Calibration::mambo(),
            sensors: Sensors::mambo(),
            space: Space { reach: 3.0, heights: Vector2::new(0.0, 3.0), latest: 3600.0 },
            course: Course::mambo(),
            limits: Limits::room(),
            parameters: Parameters::mambo(),
            injection: Injection::none(),
            choice: Choice::usual(),
        }
    }
}

/// What comes in in one period.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// The processor's clock, µs.
    pub time: u64,
    /// The sensors.
    pub readings: Readings,
    /// A packet from the ground; of no length, if none came.
    pub uplink: Packet,
}

/// What goes out in one period.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// To the motors.
    pub command: Command,
    /// What is known of the aircraft.
    pub estimate: Estimate,
    /// How long its parts have gone unmeasured.
    pub ages: Ages,
    /// Where it is wanted.
    pub reference: Reference,
    /// The share of the feed-forward that is injected.
    pub gain: f64,
    /// What is wrong.
    pub alarm: Alarm,
    /// A packet for the ground; of no length, if there is none.
    pub downlink: Packet,
}

/// The onboard software.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Onboard {
    /// Watches the processor's clock.
    pub clock: ClockMonitor,
    /// Listens to the ground.
    pub receiver: Receiver,
    /// Knows where the aircraft is.
    pub estimator: Estimator,
    /// What the motors were told to do to the aircraft.
    pub pushed: Push,
    /// Knows where it is wanted.
    pub reference: ReferenceGenerator,
    /// Sees trouble coming.
    pub predictor: CrashPredictor,
    /// Closes the loop.
    pub controller: Controller,
    /// Writes down.
    pub logger: Logger,
    /// Sends what was written down.
    pub sender: Sender,
}

#[component]
impl Onboard {
    /// One period.
    #[entry(infallible)]
    pub fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs {
        let period = settings.parameters.period;
        self.receiver.step(period, &settings.space, &inputs.uplink);

        let measured = settings.calibration.measured(&inputs.readings);
        let estimate = self.estimator.step(&settings.sensors, &self.pushed, &measured);
        let alarm = self.watch(settings, inputs.time, &estimate);
        if alarm != Alarm::Clear {
            self.reference.end();
        }

        let landed = self.controller.touch_down.landed;
        let orders = &self.receiver.orders;
        let limp = self.estimator.is_deaf();
        let reference = self.reference.step(&settings.course, orders, &estimate, landed, limp);
        let gain = self.gain(settings, &reference);
        let mut command = Command::still();
        if reference.motors {
            let whole = compensation(&settings.airframe, &estimate, settings.injection.friction);
            let parameters = &settings.parameters;
            let target = &reference.target;
            command = self.controller.step(parameters, &estimate, target, &(whole * gain));
        }
        self.pushed = settings.parameters.push(&command);

        let ages = self.estimator.ages;
        let mut outputs =
            Outputs { command, estimate, ages, reference, gain, alarm, downlink: Packet::none() };
        self.logger.step(&settings.choice, &signals(&outputs));
        if self.receiver.orders.link {
            outputs.downlink = self.sender.step(&mut self.logger);
        }
        outputs
    }

    /// Whether to go on.
    fn watch(&mut self, settings: &Settings, time: u64, estimate: &Estimate) -> Alarm {
        if self.receiver.orders.stop {
            self.predictor.raise(Alarm::Asked);
        }
        if !self.clock.step(settings.parameters.period, time) {
            self.predictor.raise(Alarm::Clock);
        }
        let flying = self.reference.is_flying();
        let climb = self.estimator.climb;
        self.predictor.step(&settings.limits, flying, estimate, &self.estimator.ages, climb)
    }

    /// The share of the feed-forward that is injected now.
    fn gain(&self, settings: &Settings, reference: &Reference) -> f64 {
        if self.receiver.orders.mode != Mode::FeedForward || reference.target.take_off {
            return 0.0;
        }
        settings.injection.gain(reference.time)
    }
}

/// Everything that the logger can be told to write down, by its number.
///
/// 0–11 the state; 12–17 the wanted position, yaw, phase and time; 18–25 the closed loop's commands;
/// 26–33 the feed-forward's; 34 its gain; 35 the alarm; 36–43 the motors' commands; 44–46 the wanted
/// velocity; 47–50 the ages of the measurements. The rest is 0.
#[function]
fn signals(outputs: &Outputs) -> SVector<f64, 64> {
    let mut all = SVector::zeros();
    let estimate = &outputs.estimate;
    let target = &outputs.reference.target;
    let command = &outputs.command;
    for n in 0..3 {
        all[n] = estimate.position[n];
        all[3 + n] = estimate.angles[n];
        all[6 + n] = estimate.velocity[n];
        all[9 + n] = estimate.rates[n];
        all[12 + n] = target.position[n];
        all[44 + n] = target.velocity[n];
    }
    all[15] = target.yaw;
    all[16] = outputs.reference.phase as u8 as f64;
    all[17] = outputs.reference.time;
    for n in 0..8 {
        all[18 + n] = command.closed_loop[n];
        all[26 + n] = command.feed_forward[n];
        all[36 + n] = command.motors[n];
    }
    all[34] = outputs.gain;
    all[35] = outputs.alarm as u8 as f64;
    all[47] = outputs.ages.inertial;
    all[48] = outputs.ages.vicon;
    all[49] = outputs.ages.height;
    all[50] = outputs.ages.plane;
    all
}
