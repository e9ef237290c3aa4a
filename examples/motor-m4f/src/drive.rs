//! The drive: from speed and currents to the duties of three half bridges.

use bessemer::prelude::*;

use crate::average::Average;
use crate::modulation::{PHASES, duties};
use crate::pi::{Gains, Pi};
use crate::ramp::Ramp;
use crate::table::{POINTS, interpolated};

/// 1/√3.
const INVERSE_ROOT_3: f32 = 0.577_350_26;
/// A supply below this does not run the motor, V.
const LEAST_SUPPLY: f32 = 6.0;

/// The state of the drive.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Mode {
    /// All switches are off.
    #[default]
    Off,
    /// The rotor is drawn to the angle 0, for so many periods more.
    Aligning { left: u16 },
    /// The speed is held.
    Running,
    /// A current was too high; until it is acknowledged, all switches are off.
    Tripped,
}

/// Currents in the rotor's frame, A.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Currents {
    /// Along the flux.
    pub direct: f32,
    /// Across it: what makes torque.
    pub quadrature: f32,
}

/// Settings of the drive.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settings {
    /// The loop of the speed: A for rad/s.
    pub speed: Gains,
    /// The loops of the currents: V for A.
    pub current: Gains,
    /// The fastest change of the speed, rad/s a period.
    pub ramp: f32,
    /// The most current, A.
    pub most_current: f32,
    /// A current that trips, A.
    pub trip_current: f32,
    /// Periods in which the rotor is drawn to a known angle.
    pub aligning: u16,
    /// 1 divided by the speed at the end of the table, s/rad.
    pub per_top_speed: f32,
    /// The direct current that weakens the field, A, from standstill to the top speed.
    pub weakening: [f32; POINTS],
}

/// Inputs of a period.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Inputs {
    /// True to run.
    pub run: bool,
    /// True to acknowledge a trip.
    pub acknowledge: bool,
    /// The wanted speed, rad/s.
    pub target: f32,
    /// The speed, electrical, rad/s.
    pub speed: f32,
    /// The rotor's angle, electrical, rad.
    pub angle: f32,
    /// Currents of the first two phases, A.
    pub currents: [f32; 2],
    /// The supply, V.
    pub supply: f32,
}

/// Outputs of a period.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outputs {
    /// True if the half bridges switch.
    pub enabled: bool,
    /// The share of the period in which each upper switch is on.
    pub duties: [f32; PHASES],
    /// The currents seen.
    pub currents: Currents,
}

/// Holds the speed of a three-phase motor.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drive {
    mode: Mode,
    speed: Average,
    ramp: Ramp,
    speed_loop: Pi,
    direct_loop: Pi,
    quadrature_loop: Pi,
}

#[component]
impl Drive {
    /// One period.
    #[entry(infallible, single)]
    pub fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs {
        let speed = self.speed.take(inputs.speed);
        self.change_mode(settings, inputs);

        let angle = match self.mode {
            Mode::Off | Mode::Tripped => {
                self.ramp = Ramp::default();
                self.speed_loop = Pi::default();
                self.direct_loop = Pi::default();
                self.quadrature_loop = Pi::default();
                return Outputs::default();
            }
            Mode::Aligning { .. } => 0.0,
            Mode::Running => inputs.angle,
        };
        let (sine, cosine) = angle.sin_cos();

        // To the rotor's frame (Clarke, Park).
        let alpha = inputs.currents[0];
        let beta = (alpha + 2.0 * inputs.currents[1]) * INVERSE_ROOT_3;
        let currents = Currents {
            direct: cosine * alpha + sine * beta,
            quadrature: cosine * beta - sine * alpha,
        };

        let wanted = self.wanted(settings, inputs.target, speed);
        let limit = inputs.supply * INVERSE_ROOT_3;
        let direct =
            self.direct_loop.respond(&settings.current, wanted.direct - currents.direct, limit);
        let quadrature = self.quadrature_loop.respond(
            &settings.current,
            wanted.quadrature - currents.quadrature,
            limit,
        );

        // And back.
        let alpha = cosine * direct - sine * quadrature;
        let beta = sine * direct + cosine * quadrature;
        Outputs { enabled: true, duties: duties(alpha, beta, inputs.supply), currents }
    }

    /// Updates the mode from the inputs.
    fn change_mode(&mut self, settings: &Settings, inputs: &Inputs) {
        let third = -inputs.currents[0] - inputs.currents[1];
        let most = settings.trip_current;
        let too_high = inputs.currents[0].abs() > most
            || inputs.currents[1].abs() > most
            || third.abs() > most;
        let can_run = inputs.run && inputs.supply > LEAST_SUPPLY;
        self.mode = match self.mode {
            Mode::Tripped if inputs.acknowledge && !too_high => Mode::Off,
            Mode::Tripped => Mode::Tripped,
            _ if too_high => Mode::Tripped,
            _ if !can_run => Mode::Off,
            Mode::Off => Mode::Aligning { left: settings.aligning },
            Mode::Aligning { left } if left > 1 => Mode::Aligning { left: left - 1 },
            _ => Mode::Running,
        };
    }

    /// The currents to hold.
    fn wanted(&mut self, settings: &Settings, target: f32, speed: f32) -> Currents {
        if self.mode != Mode::Running {
            return Currents { direct: settings.most_current, quadrature: 0.0 };
        }
        let target = self.ramp.follow(target, settings.ramp);
        let error = target - speed;
        Currents {
            direct: interpolated(&settings.weakening, speed.abs() * settings.per_top_speed),
            quadrature: self.speed_loop.respond(&settings.speed, error, settings.most_current),
        }
    }
}
