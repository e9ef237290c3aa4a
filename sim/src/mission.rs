//! A mission: the commands to the pilot with their times, and the air.
//!
//! Does not know how well it is flown: see [`crate::verdict`].

use crate::plant::State;
use bessemer_sim::Events;
use models::Target;
use nalgebra::Vector3;
use std::f64::consts::FRAC_PI_2;

/// Commands to the pilot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// Climb for `burn` seconds with the take-off flag set, then hold `height`, m.
    TakeOff {
        /// Duration of the take-off flag, s.
        burn: f64,
        /// Height to hold afterwards, m.
        height: f64,
    },
    /// Turn to a yaw, rad.
    Turn(f64),
    /// Fly to a position, x and y, m.
    Go(f64, f64),
    /// Descend at a rate, m/s (thesis, eq. (3.20)), and stop the motors on touch-down.
    Land(f64),
}

/// An action and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Manoeuvre {
    /// Name of the manoeuvre.
    pub name: &'static str,
    /// Command to the pilot.
    pub action: Action,
}

/// A gust that twists the aircraft in one direction and then, for the same time, in the other.
///
/// It leaves hardly any tilt, but shows whether each motor has the effect that the pilot assumes: if not, resisting
/// the gust rotates the aircraft about another axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Gust {
    /// Name of the gust.
    pub name: &'static str,
    /// Start of the gust, s.
    pub begins: f64,
    /// Duration of the gust in each direction, s.
    pub lasts: f64,
    /// Torque about the body's axes in the first half, N·m.
    pub torque: Vector3<f64>,
}

impl Gust {
    /// Returns the end of the gust, s.
    pub fn ends(&self) -> f64 {
        self.begins + 2.0 * self.lasts
    }

    /// Torque about the body's axes at a time, N·m.
    fn torque(&self, time: f64) -> Vector3<f64> {
        let elapsed = time - self.begins;
        if elapsed < 0.0 || time >= self.ends() {
            Vector3::zeros()
        } else if elapsed < self.lasts {
            self.torque
        } else {
            -self.torque
        }
    }
}

/// A planned flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Mission {
    /// Duration of the mission, s.
    pub duration: f64,
    /// Initial state of the aircraft.
    pub start: State,
    /// Commands, each at the start of its manoeuvre; the last is the landing.
    pub manoeuvres: Events<Manoeuvre>,
    /// Steady force of the air in the inertial frame, N.
    pub wind: Vector3<f64>,
    /// Gusts, in the order of time.
    pub gusts: Vec<Gust>,
}

impl Mission {
    /// The flight that uses every channel of the controller.
    ///
    /// The times leave the place (the slowest of the loops, at the thesis' gains) as long as it
    /// needs. The yaw step drives every motor to a limit. The updraft is there for the integral of
    /// the height, the gusts for the mixer.
    pub fn every_channel() -> Self {
        let manoeuvre = |name, begins, action| (begins, Manoeuvre { name, action });
        let gust = |name, begins, torque| Gust { name, begins, lasts: 0.02, torque };
        Self {
            duration: 30.0,
            start: State {
                position: Vector3::new(0.3, -0.2, 0.0),
                angles: Vector3::new(0.1, 0.0, 0.1),
                ..State::default()
            },
            manoeuvres: [
                manoeuvre("take-off", 0.0, Action::TakeOff { burn: 1.0, height: 1.0 }),
                manoeuvre("yaw step", 13.0, Action::Turn(FRAC_PI_2)),
                manoeuvre("x step", 15.0, Action::Go(1.0, 0.0)),
                manoeuvre("landing", 25.75, Action::Land(0.28)),
            ]
            .into_iter()
            .collect(),
            wind: Vector3::new(0.0, 0.0, 0.012),
            gusts: vec![
                gust("gust in pitch", 9.0, Vector3::new(0.0, 0.003, 0.0)),
                gust("gust in roll", 11.0, Vector3::new(0.003, 0.0, 0.0)),
            ],
        }
    }

    /// Returns the target of the pilot at a time, s.
    pub fn target(&self, time: f64) -> Target {
        let mut target = Target::default();
        for (begins, manoeuvre) in self.manoeuvres.past(time) {
            manoeuvre.action.apply(time - begins, &mut target);
        }
        target
    }

    /// Torque of the gusts about the body's axes at a time, N·m.
    pub fn twist(&self, time: f64) -> Vector3<f64> {
        self.gusts.iter().map(|gust| gust.torque(time)).sum()
    }
}

impl Action {
    /// Applies an action to the target, `elapsed` seconds after its beginning.
    fn apply(self, elapsed: f64, target: &mut Target) {
        match self {
            Action::TakeOff { burn, height } => {
                target.take_off = elapsed < burn;
                target.position.z = height;
            }
            Action::Turn(yaw) => target.yaw = yaw,
            Action::Go(x, y) => {
                target.position.x = x;
                target.position.y = y;
            }
            Action::Land(rate) => {
                target.land = true;
                target.position.z -= rate * elapsed;
                target.velocity.z = -rate;
            }
        }
    }
}
