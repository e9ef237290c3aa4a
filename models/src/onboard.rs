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
use crate::gate::Refused;
use crate::logger::{Choice, Logger, SIGNALS};
use crate::packet::Packet;
use crate::parameters::Parameters;
use crate::receiver::{Mode, Receiver, Request, Wish};
use crate::reference_generator::{Course, Reference, ReferenceGenerator};
use crate::sender::{Reply, Sender, Status};
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
    /// What the gate before the link has kept out so far.
    pub refused: Refused,
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
    /// Variances of the position, m², and of the angles, rad².
    pub spread: Vector6<f64>,
    /// The share of the feed-forward that is injected.
    pub gain: f64,
    /// What the ground wants of the settings: for whoever holds them, before the next period.
    pub wish: Wish,
    /// What is wrong.
    pub alarm: Alarm,
    /// A packet for the ground; of no length, if there is none.
    pub downlink: Packet,
}

/// How fast the share of the feed-forward may change, 1/s: at once, it would throw the aircraft up.
#[data]
const SWELL: f64 = 0.1;

/// An aircraft stands on the ground if it is lower than this, m, and slower than this, m/s.
#[data]
const STANDING: [f64; 2] = [0.1, 0.1];

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
    /// The share of the feed-forward that is injected.
    pub gain: f64,
    /// The parameter that the ground has asked for.
    pub reply: Reply,
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
        if self.receiver.orders.arm {
            self.arm(&estimate);
        }
        let alarm = self.watch(settings, inputs.time, &estimate);
        if alarm != Alarm::Clear {
            self.reference.end();
        }

        let landed = self.controller.touch_down.landed;
        let orders = &self.receiver.orders;
        let limp = self.estimator.is_deaf();
        let reference = self.reference.step(&settings.course, orders, &estimate, landed, limp);
        self.swell(settings, &reference);
        let mut command = Command::still();
        if reference.motors {
            let whole = compensation(&settings.airframe, &estimate, settings.injection.friction);
            let parameters = &settings.parameters;
            let target = &reference.target;
            let share = whole * self.gain;
            command = self.controller.step(parameters, &estimate, target, &share);
        }
        self.pushed = settings.parameters.push(&command);

        let mut outputs = Outputs {
            command,
            estimate,
            ages: self.estimator.ages,
            reference,
            spread: self.estimator.spread(),
            gain: self.gain,
            wish: self.receiver.wish,
            alarm,
            downlink: Packet::none(),
        };
        self.logger.step(&settings.choice, &signals(&outputs));
        if self.receiver.orders.link {
            outputs.downlink = self.send(settings, &inputs.refused);
        }
        outputs
    }

    /// Makes ready for another flight, if the aircraft stands on the ground with its motors off.
    fn arm(&mut self, estimate: &Estimate) {
        let [low, slow] = STANDING;
        let stands = estimate.position.z < low && estimate.velocity.norm() < slow;
        if !self.reference.is_flying() && stands {
            self.receiver.forget();
            self.reference = ReferenceGenerator::default();
            self.predictor = CrashPredictor::default();
            self.controller = Controller::default();
            self.gain = 0.0;
        }
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

    /// The share of the feed-forward on its way to what is injected now.
    fn swell(&mut self, settings: &Settings, reference: &Reference) {
        if !reference.motors || reference.target.take_off {
            self.gain = 0.0;
            return;
        }
        let mut wanted = 0.0;
        if self.receiver.orders.mode == Mode::FeedForward {
            wanted = settings.injection.gain(reference.time);
        }
        let most = SWELL * settings.parameters.period;
        self.gain += (wanted - self.gain).max(-most).min(most);
    }

    /// What goes down in this period. A parameter that is asked for in it goes down in the next one, when a
    /// change of it has taken place.
    fn send(&mut self, settings: &Settings, refused: &Refused) -> Packet {
        let status = Status {
            tally: self.receiver.tally,
            refused: *refused,
            lost: self.logger.lost,
            mode: self.receiver.orders.mode,
            tag: self.receiver.orders.tag,
            watched: self.receiver.orders.watched,
        };
        self.reply.value = settings.parameter(self.reply.number);
        let packet = self.sender.step(&mut self.logger, &status, &self.reply);
        let wish = &self.receiver.wish;
        self.reply.wanted = wish.request == Request::Ask || wish.request == Request::Set;
        self.reply.number = wish.number;
        packet
    }
}

/// Everything that the logger can be told to write down, by its number.
///
/// 0–11 the state; 12–17 the wanted position, yaw, phase and time; 18–25 the closed loop's commands;
/// 26–33 the feed-forward's; 34 its gain; 35 the alarm; 36–43 the motors' commands; 44–46 the wanted
/// velocity; 47–50 the ages of the measurements; 51–56 the variances of position and angles. The rest is 0.
#[function]
pub fn signals(outputs: &Outputs) -> SVector<f64, SIGNALS> {
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
    for n in 0..6 {
        all[51 + n] = outputs.spread[n];
    }
    all
}
