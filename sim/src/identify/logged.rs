//! The data of a logged flight for identification: the motors' commands and the estimates.
//!
//! Knows the log's signals by name; uses nothing of the true state, even if the log of a simulation has it.

use crate::recording::{Error, Log};
use models::plant::Motion;
use nalgebra::{SVector, Vector3};

/// A state in the thesis' order (2.18).
pub type State = SVector<f64, 12>;

/// Height above which the aircraft flies freely, m.
const FREE: f64 = 0.15;

/// A logged flight.
#[derive(Clone, Debug, PartialEq)]
pub struct Logged {
    /// Time between two rows, s.
    pub period: f64,
    /// States of all rows.
    pub states: Vec<State>,
    /// Squares of the speeds of the motors over the period that follows, rad²/s².
    pub squares: Vec<SVector<f64, 8>>,
    /// The range of rows in free flight: the first, and the one after the last.
    pub airborne: (usize, usize),
}

impl Logged {
    /// Extracts the data for identification from a log. The motors follow their commands with the time constant
    /// `lag`, s, from the data sheet.
    ///
    /// # Errors
    ///
    /// A signal is missing, or the aircraft never flew.
    pub fn of(log: &Log, lag: f64) -> Result<Self, Error> {
        let column = |name: &str| log.column(name);
        let names = ["x", "y", "z", "roll", "pitch", "yaw", "vx", "vy", "vz", "p", "q", "r"];
        let mut columns = Vec::new();
        for name in names {
            columns.push(column(&format!("estimate.{name}"))?);
        }
        let mut speeds = Vec::new();
        for motor in 1..=6 {
            speeds.push(column(&format!("motors.speed{motor}"))?);
        }
        let times = column("estimate.time")?;
        let period = match times {
            [first, .., last] => (last - first) / (times.len() - 1) as f64,
            _ => return Err(log.lacks("two rows")),
        };
        let states: Vec<State> =
            (0..times.len()).map(|row| State::from_fn(|n, _| columns[n][row])).collect();
        let wanted =
            |row: usize| SVector::from_fn(|n, _| speeds.get(n).map_or(0.0, |s| s[row].abs()));
        let squares = turning((0..times.len()).map(wanted), lag, period);

        let phase = column("reference.phase")?;
        let flies = |row: &usize| states[*row][2] > FREE && (1.0..4.0).contains(&phase[*row]);
        let first = (0..times.len()).find(flies).ok_or_else(|| log.lacks("flight"))?;
        let last = (first..times.len()).take_while(flies).last().unwrap_or(first);
        Ok(Self { period, states, squares, airborne: (first, last + 1) })
    }

    /// The range of each output while airborne (thesis, eq. (5.3)).
    pub fn ranges(&self) -> State {
        let rows = &self.states[self.airborne.0..self.airborne.1];
        State::from_fn(|n, _| {
            let values = rows.iter().map(|state| state[n]);
            let (low, high) = values
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v: f64| (l.min(v), h.max(v)));
            high - low
        })
    }
}

/// Returns the mean squares of the speeds of motors that follow their commands.
fn turning(
    wanted: impl Iterator<Item = SVector<f64, 8>>,
    lag: f64,
    period: f64,
) -> Vec<SVector<f64, 8>> {
    let mut motors = crate::motors::Motors::new(lag);
    let halves = |goal: SVector<f64, 8>| {
        let first = motors.turn(&goal, period / 2.0);
        (first + motors.turn(&goal, period / 2.0)) / 2.0
    };
    wanted.map(halves).collect()
}

/// Converts a state to the model's form.
pub fn motion(state: &State) -> Motion {
    let part = |n: usize| Vector3::new(state[n], state[n + 1], state[n + 2]);
    Motion { position: part(0), angles: part(3), velocity: part(6), rates: part(9) }
}

/// Converts a state to the log's form.
pub fn state(motion: &Motion) -> State {
    let mut all = State::zeros();
    let parts = [motion.position, motion.angles, motion.velocity, motion.rates];
    for (n, part) in parts.iter().enumerate() {
        all.fixed_rows_mut::<3>(3 * n).copy_from(part);
    }
    all
}
