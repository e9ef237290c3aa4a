//! The random scenario of a seed.
//!
//! The software's assumptions are wrong by up to 10 %: mass, inertia, arm, air, each propeller. Noise, lag, air,
//! trajectory, Vicon's outages and the start are random, too.

use crate::noise::{Purpose, Stream};
use crate::plant::State;
use crate::scenario::{Failure, Gain, Scenario, point};
use crate::sensors::{Senses, Sensor};
use models::{Airframe, Mode};
use nalgebra::Vector3;
use std::f64::consts::PI;

/// Start of the landing, s.
const LANDING: f64 = 28.0;

/// Source of the numbers of a scenario.
pub trait Dice {
    /// Returns a number that is uniform from `least` to `most`.
    fn between(&mut self, least: f64, most: f64) -> f64;

    /// Returns a whole number from 0 to below `count`.
    fn below(&mut self, count: u64) -> u64;
}

impl Dice for Stream {
    fn between(&mut self, least: f64, most: f64) -> f64 {
        Stream::between(self, least, most)
    }

    fn below(&mut self, count: u64) -> u64 {
        Stream::below(self, count)
    }
}

/// Returns the scenario of a seed without a failure.
pub fn scenario(seed: u64) -> Scenario {
    drawn(&mut Stream::new(seed, Purpose::Dice), seed)
}

/// Returns a scenario without a failure from numbers of any source; `seed` is that of noise and gusts.
pub fn drawn(dice: &mut impl Dice, seed: u64) -> Scenario {
    let points = [
        point(0.0, 0.0, 0.0, dice.between(0.7, 1.3), 0.0),
        somewhere(dice, 8.0),
        somewhere(dice, 18.0),
    ];
    let mut scenario = Scenario::mambo(&points, LANDING, Mode::ClosedLoop);
    scenario.seed = seed;
    scenario.airframe = airframe(dice);
    scenario.lag *= dice.between(0.7, 1.3);
    scenario.start = State {
        position: Vector3::new(dice.between(-0.3, 0.3), dice.between(-0.3, 0.3), 0.0),
        angles: Vector3::new(
            dice.between(-0.03, 0.03),
            dice.between(-0.03, 0.03),
            dice.between(-0.3, 0.3),
        ),
        ..State::default()
    };
    scenario.air.steady =
        Vector3::new(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), 0.0) * 0.01;
    scenario.air.gusts = dice.between(0.0, 0.006);
    scenario.senses = Senses::usual().scaled(dice.between(0.5, 1.5));
    for _ in 0..dice.below(4) {
        let from = dice.between(2.0, 30.0);
        scenario.hide(from, from + dice.between(0.2, 5.0));
    }
    scenario
}

/// Returns the scenario of a seed with a failure.
pub fn failing(seed: u64) -> Scenario {
    let mut scenario = scenario(seed);
    let mut dice = Stream::new(seed ^ 0x5EED_FA11, Purpose::Dice);
    let at = dice.between(6.0, 24.0);
    let failure = match dice.below(3) {
        0 => Failure::Motor(dice.below(4) as usize),
        1 => {
            let sensors =
                [Sensor::Gyroscope, Sensor::Accelerometer, Sensor::Altimeter, Sensor::Vicon];
            Failure::Sensor(sensors[dice.below(4) as usize])
        }
        _ => {
            let gains = [Gain::Roll, Gain::Pitch, Gain::Height, Gain::Along];
            Failure::Gain(gains[dice.below(4) as usize])
        }
    };
    scenario.fail(at, failure);
    scenario
}

fn somewhere(dice: &mut impl Dice, time: f64) -> models::trajectory::SetPoint {
    let (x, y) = (dice.between(-0.5, 0.5), dice.between(-0.5, 0.5));
    point(time, x, y, dice.between(0.6, 1.8), dice.between(-PI, PI))
}

fn airframe(dice: &mut impl Dice) -> Airframe {
    let mut off = || dice.between(0.9, 1.1);
    let mut airframe = Airframe::mambo();
    airframe.mass *= off();
    airframe.inertia = airframe.inertia.component_mul(&Vector3::new(off(), off(), off()));
    airframe.arm *= off();
    airframe.air_density *= off();
    for n in 0..airframe.motors {
        airframe.thrust_coefficients[n] *= off();
        airframe.drag_coefficients[n] *= off();
    }
    airframe
}
