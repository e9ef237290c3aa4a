//! The parameters that the ground can ask for and set, each by a number.
//!
//! A value out of its parameter's range is refused, and so is one that must not change in flight. Names and
//! units are told on the ground; here is what the numbers mean and how far they go.

use crate::onboard::Settings;
use crate::parameters::Candidate;
use crate::receiver::{Request, Wish};
use bessemer::prelude::*;

/// How many parameters there are.
#[data]
pub const TUNABLE: usize = 20;

/// From this number on they change on the ground only.
#[data]
pub const GROUNDED: usize = 18;

/// The least values, in the order of [`values`].
#[data]
pub const LEAST: [f64; TUNABLE] = [
    0.5, 0.0, 0.1, 0.004, 0.0, 0.001, 0.005, 0.0, 0.001, 0.001, 0.0004, -0.4, -0.2, -0.4, -0.2,
    0.0, -0.05, 0.1, 0.1, 0.0,
];

/// The largest values.
#[data]
pub const MOST: [f64; TUNABLE] = [
    3.0, 0.2, 0.8, 0.02, 0.02, 0.005, 0.025, 0.02, 0.004, 0.01, 0.0025, -0.1, -0.04, -0.1, -0.04,
    0.8, 0.05, 0.5, 0.4, 2.0,
];

/// What the parameters are now: P, I and D of the height (N/m, N/(m·s), N·s/m), of roll and of pitch
/// (N·m/rad …), P and D of yaw, of x and of y (rad/m, rad·s/m); the final gain of the feed-forward, the
/// friction that it takes away (N·s/m); the rate of the landing (m/s); and, on the ground only, the excess of the
/// take-off's thrust and the number of the candidate.
#[function]
pub fn values(settings: &Settings) -> [f64; TUNABLE] {
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
        settings.course.sink,
        all.takeoff_gain,
        all.candidate as u8 as f64,
    ]
}

#[data]
impl Settings {
    /// The value of a parameter; no number, if there is none of that number.
    pub fn parameter(&self, number: u8) -> f64 {
        let n = number as usize;
        if n >= TUNABLE {
            return f64::NAN;
        }
        values(self)[n]
    }

    /// Changes what the ground wants changed, if that can be: whether it was.
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

    /// Sets a parameter: whether that can be.
    pub fn set(&mut self, number: u8, value: f64, flying: bool) -> bool {
        let n = number as usize;
        if n >= TUNABLE || (flying && n >= GROUNDED) {
            return false;
        }
        let good = value >= LEAST[n] && value <= MOST[n];
        if !good {
            return false;
        }
        let mut all = values(self);
        all[n] = value;
        self.take_gains(&all);
        self.injection.most = all[15];
        self.injection.friction = all[16];
        self.course.sink = all[17];
        self.parameters.takeoff_gain = all[18];
        self.parameters.candidate = candidate(all[19]);
        true
    }

    /// The gains, in the order of [`values`].
    fn take_gains(&mut self, all: &[f64; TUNABLE]) {
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

/// The candidate of a number: see [`Candidate`].
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
