//! Parameters that the ground station can query and set, each by a number.
//!
//! A value outside its range is rejected, and so is a change that is forbidden in flight. Names and units are defined
//! by the ground station.

use crate::onboard::Settings;
use crate::parameters::Candidate;
use crate::receiver::{Request, Wish};
use bessemer::prelude::*;

/// Number of parameters.
#[data]
pub const PARAMETER_COUNT: usize = 23;

/// Number of the first parameter that changes on the ground only.
#[requirement("HLR-32")]
#[data]
pub const FIRST_GROUND_ONLY: usize = 18;

/// Largest number of motors of a small quadcopter, whose parameters have ranges of their own.
#[data]
const SMALL_MOTORS: usize = 4;

/// Least value of each parameter of the Mambo.
#[data]
pub const LEAST_VALUES: [f64; PARAMETER_COUNT] = [
    0.5, 0.0, 0.1, 0.004, 0.0, 0.001, 0.005, 0.0, 0.001, 0.001, 0.0004, -0.4, -0.4, -0.4, -0.4,
    0.0, -0.05, 0.1, 0.1, 0.0, 0.2, 0.5, 5.0,
];

/// Largest value of each parameter of the Mambo.
#[data]
pub const LARGEST_VALUES: [f64; PARAMETER_COUNT] = [
    3.0, 0.2, 0.8, 0.02, 0.02, 0.005, 0.025, 0.02, 0.004, 0.01, 0.0025, -0.1, -0.04, -0.1, -0.04,
    0.8, 0.05, 0.5, 0.4, 2.0, 2.5, 5.0, 100.0,
];

/// Least value of each parameter of the hexacopter.
#[data]
pub const HEXACOPTER_LEAST_VALUES: [f64; PARAMETER_COUNT] = [
    4.0, 0.0, 2.0, 0.5, 0.0, 0.1, 0.5, 0.0, 0.1, 0.03, 0.03, -0.4, -0.3, -0.4, -0.3, 0.0, -0.5,
    0.1, 0.1, 0.0, 0.2, 0.5, 5.0,
];

/// Largest value of each parameter of the hexacopter.
#[data]
pub const HEXACOPTER_LARGEST_VALUES: [f64; PARAMETER_COUNT] = [
    40.0, 4.0, 16.0, 5.0, 1.5, 1.0, 5.0, 1.5, 1.0, 0.5, 0.3, -0.1, -0.04, -0.1, -0.04, 0.8, 0.5,
    0.5, 0.4, 2.0, 2.5, 5.0, 100.0,
];

/// Returns the present values. P, I and D of the height (N/m, N/(m·s), N·s/m), of roll and of pitch (N·m/rad …); P and
/// D of yaw, of x and of y (rad/m, rad·s/m). Then the final gain of the feed-forward, the friction that it cancels
/// (N·s/m) and the landing rate (m/s). On the ground only: the excess thrust of the take-off, the number of the
/// control law, and the largest speed (m/s), acceleration (m/s²) and jerk (m/s³) of the set point.
#[function]
pub fn values(settings: &Settings) -> [f64; PARAMETER_COUNT] {
    let all = &settings.parameters;
    [
        all.height.p,
        all.height.i,
        all.height.d,
        all.roll.p,
        all.roll.i,
        all.roll.d,
        all.pitch.p,
        all.pitch.i,
        all.pitch.d,
        all.yaw.p,
        all.yaw.d,
        all.x.p,
        all.x.d,
        all.y.p,
        all.y.d,
        settings.injection.most,
        settings.injection.friction,
        settings.course.landing_rate,
        all.takeoff_gain,
        all.candidate as u8 as f64,
        settings.course.shaping.speed,
        settings.course.shaping.acceleration,
        settings.course.shaping.jerk,
    ]
}

#[data]
impl Settings {
    /// Returns the value of a parameter, or NaN if there is no such parameter.
    pub fn parameter(&self, number: u8) -> f64 {
        let n = number as usize;
        if n >= PARAMETER_COUNT {
            return f64::NAN;
        }
        values(self)[n]
    }

    /// Applies a request of the ground station if it is valid; returns true if so.
    #[requirement("HLR-32")]
    pub fn grant(&mut self, wish: &Wish, flying: bool) -> bool {
        match wish.request {
            Request::Set => self.set(wish.number, wish.value, flying),
            Request::Choose => {
                self.choice = wish.choice;
                true
            }
            Request::Nothing | Request::Ask => false,
        }
    }

    /// Sets a parameter if the value is valid; returns true if so.
    #[requirement("HLR-32")]
    pub fn set(&mut self, number: u8, value: f64, flying: bool) -> bool {
        let n = number as usize;
        if n >= PARAMETER_COUNT || (flying && n >= FIRST_GROUND_ONLY) {
            return false;
        }
        let small = self.airframe.motors <= SMALL_MOTORS;
        let least = if small { LEAST_VALUES[n] } else { HEXACOPTER_LEAST_VALUES[n] };
        let most = if small { LARGEST_VALUES[n] } else { HEXACOPTER_LARGEST_VALUES[n] };
        let good = value >= least && value <= most;
        if !good {
            return false;
        }
        let mut all = values(self);
        all[n] = value;
        self.take_gains(&all);
        self.injection.most = all[15];
        self.injection.friction = all[16];
        self.course.landing_rate = all[17];
        self.parameters.takeoff_gain = all[18];
        self.parameters.candidate = candidate(all[19]);
        self.course.shaping.speed = all[20];
        self.course.shaping.acceleration = all[21];
        self.course.shaping.jerk = all[22];
        true
    }

    /// Sets the gains to the values of the parameters.
    fn take_gains(&mut self, all: &[f64; PARAMETER_COUNT]) {
        let mine = &mut self.parameters;
        mine.height.p = all[0];
        mine.height.i = all[1];
        mine.height.d = all[2];
        mine.roll.p = all[3];
        mine.roll.i = all[4];
        mine.roll.d = all[5];
        mine.pitch.p = all[6];
        mine.pitch.i = all[7];
        mine.pitch.d = all[8];
        mine.yaw.p = all[9];
        mine.yaw.d = all[10];
        mine.x.p = all[11];
        mine.x.d = all[12];
        mine.y.p = all[13];
        mine.y.d = all[14];
    }
}

/// Returns the control law of a number.
#[function]
fn candidate(number: f64) -> Candidate {
    if number >= 1.5 {
        Candidate::Geometric
    } else if number >= 0.5 {
        Candidate::Printed
    } else {
        Candidate::Cascade
    }
}
