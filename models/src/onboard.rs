//! The complete onboard software (thesis, ch. 6): all steps of one period in order.
//!
//! It only composes the components. Receiver, estimator, reference, controller, mixer and sender run in each period,
//! at 200 Hz; sensors and logger have their own rates.

use crate::airframe::Airframe;
use crate::calibration::{Calibration, Readings};
use crate::clock_monitor::ClockMonitor;
use crate::controller::Controller;
use crate::crash_predictor::{Alarm, CrashPredictor, Limits};
use crate::estimator::{Ages, Estimator, Sensors};
use crate::expectation::Push;
use crate::feed_forward::{Injection, compensation};
use crate::gate::Refused;
use crate::geometry::Orientation;
use crate::logger::{Choice, Logger, SIGNALS};
use crate::packet::Packet;
use crate::parameters::Parameters;
use crate::receiver::{Mode, Receiver, Request, Wish};
use crate::reference_generator::{Course, Reference, ReferenceGenerator};
use crate::sender::{Reply, Sender, Status};
use crate::signals::{Command, Estimate};
use crate::trajectory::Space;
use bessemer::prelude::*;

/// All settings of a flight.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settings {
    /// Airframe assumed by the feed-forward.
    pub airframe: Airframe,
    /// Scales of the sensors.
    pub calibration: Calibration,
    /// Noise of the sensors, and limits of their readings.
    pub sensors: Sensors,
    /// Limits of trajectories.
    pub space: Space,
    /// Timing of take-off, landing and timeouts.
    pub course: Course,
    /// Limits that stop the motors.
    pub limits: Limits,
    /// Parameters of the closed loop.
    pub parameters: Parameters,
    /// Parameters of the feed-forward.
    pub injection: Injection,
    /// Selection of logged signals.
    pub choice: Choice,
}

#[data]
impl Settings {
    /// Returns the settings of the Mambo in a room.
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

    /// Returns the settings of the hexacopter in a room.
    pub fn hexacopter() -> Settings {
        Settings {
            airframe: Airframe::hexacopter(),
            parameters: Parameters::hexacopter(),
            ..Settings::mambo()
        }
    }
}

/// Inputs of one period.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// Processor time, µs.
    pub time: u64,
    /// Sensor readings.
    pub readings: Readings,
    /// Packet from the ground station; length 0 if none came.
    pub uplink: Packet,
    /// Number of packets that the gate has rejected so far.
    pub refused: Refused,
}

/// Outputs of one period.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// Motor commands.
    pub command: Command,
    /// State estimate.
    pub estimate: Estimate,
    /// Ages of the measurements.
    pub ages: Ages,
    /// Reference: the target, and the phase of the flight.
    pub reference: Reference,
    /// Variances of the position, m², and of the angles, rad².
    pub variances: Vector6<f64>,
    /// Present gain of the feed-forward.
    pub gain: f64,
    /// Change of settings that the ground station requests, applied by the caller before the next period.
    pub wish: Wish,
    /// Alarm of the crash predictor.
    pub alarm: Alarm,
    /// Packet for the ground station; length 0 if there is none.
    pub downlink: Packet,
}

/// Largest rate of change of the feed-forward's gain, 1/s: a step would throw the aircraft up.
#[requirement("HLR-19")]
#[data]
const GAIN_RATE: f64 = 0.1;

/// Height, m, and speed, m/s, below which the aircraft is at rest on the ground.
#[requirement("HLR-33")]
#[data]
const REST_LIMITS: [f64; 2] = [0.1, 0.1];

/// The onboard software.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Onboard {
    /// Monitor of the processor's clock.
    pub clock: ClockMonitor,
    /// Receiver of the ground station's commands.
    pub receiver: Receiver,
    /// State estimator.
    pub estimator: Estimator,
    /// Accelerations that the last commands are to cause.
    pub commanded: Push,
    /// Generator of the target.
    pub reference: ReferenceGenerator,
    /// Crash predictor.
    pub predictor: CrashPredictor,
    /// Closed loop.
    pub controller: Controller,
    /// Data logger.
    pub logger: Logger,
    /// Downlink of the logged records.
    pub sender: Sender,
    /// Present gain of the feed-forward.
    pub gain: f64,
    /// Parameter that the ground station has requested.
    pub reply: Reply,
}

#[component]
impl Onboard {
    /// Advances one period.
    #[requirement("HLR-16", "HLR-33", "HLR-34", "HLR-37")]
    #[entry(infallible)]
    pub fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs {
        let period = settings.parameters.period;
        self.receiver.step(period, &settings.space, &inputs.uplink);

        let measured = settings.calibration.measured(&inputs.readings);
        let estimate = self.estimator.step(&settings.sensors, &self.commanded, &measured);
        if self.receiver.orders.arm {
            self.arm(&estimate);
        }
        if self.receiver.orders.disarm && !self.reference.is_flying() {
            self.reference.end();
        }
        let orientation = Orientation::of(&estimate.angles);
        let alarm = self.watch(settings, inputs.time, &estimate, &orientation);
        if alarm != Alarm::Clear {
            self.reference.end();
        }

        let landed = self.controller.touch_down.landed;
        let orders = &self.receiver.orders;
        let degraded = self.estimator.gyro_lost();
        let reference = self.reference.step(&settings.course, orders, &estimate, landed, degraded);
        self.update_gain(settings, &reference);
        let command = if reference.motors {
            let friction = settings.injection.friction;
            let velocity = &estimate.velocity;
            let whole = compensation(&settings.airframe, &orientation, velocity, friction);
            let parameters = &settings.parameters;
            let target = &reference.target;
            let share = whole * self.gain;
            self.controller.step(parameters, &estimate, target, &share)
        } else {
            Command::still()
        };
        self.commanded = settings.parameters.push(&command);

        let mut outputs = Outputs {
            command,
            estimate,
            ages: self.estimator.ages,
            reference,
            variances: self.estimator.variances(),
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

    /// Prepares another flight, if the aircraft is at rest on the ground with its motors off.
    #[requirement("HLR-33", "HLR-37")]
    fn arm(&mut self, estimate: &Estimate) {
        let [low, slow] = REST_LIMITS;
        let at_rest = estimate.position.z < low && estimate.velocity.norm() < slow;
        if !self.reference.is_flying() && at_rest {
            self.receiver.forget();
            self.reference = ReferenceGenerator::default();
            self.predictor = CrashPredictor::default();
            self.controller = Controller::default();
            self.gain = 0.0;
        }
    }

    /// Updates the alarms and returns the present one.
    #[requirement("HLR-34", "HLR-38", "HLR-39")]
    fn watch(
        &mut self,
        settings: &Settings,
        time: u64,
        estimate: &Estimate,
        orientation: &Orientation,
    ) -> Alarm {
        if self.receiver.orders.stop {
            self.predictor.raise(Alarm::Commanded);
        }
        if !self.clock.step(settings.parameters.period, time) {
            self.predictor.raise(Alarm::Clock);
        }
        let flying = self.reference.is_flying();
        let climb = self.estimator.climb;
        let ages = &self.estimator.ages;
        self.predictor.step(&settings.limits, flying, estimate, orientation, ages, climb)
    }

    /// Moves the gain of the feed-forward towards its setpoint.
    #[requirement("HLR-19")]
    fn update_gain(&mut self, settings: &Settings, reference: &Reference) {
        if !reference.motors || reference.target.take_off {
            self.gain = 0.0;
            return;
        }
        let mut wanted = 0.0;
        if self.receiver.orders.mode == Mode::FeedForward {
            wanted = settings.injection.gain(reference.time);
        }
        let most = GAIN_RATE * settings.parameters.period;
        self.gain += (wanted - self.gain).max(-most).min(most);
    }

    /// Returns the packet to send in this period. A requested parameter is sent in the next period, after a change of
    /// it has been applied.
    #[requirement("HLR-40")]
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

/// Returns all signals that the logger can record, by number.
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
        all[51 + n] = outputs.variances[n];
    }
    all
}
