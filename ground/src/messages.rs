//! The messages to and from the browser: JSON over a WebSocket, each an object with a `type`.
//!
//! Only data. Whoever reads a message has checked who sent it.

use crate::bench::{Injection, Timing};
use crate::catalogue::{Parameter, Signal};
use crate::radio::Counts;
use crate::station::{Down, Outcome};
use models::receiver::Mode;
use serde::{Deserialize, Serialize};

/// A set point, as the page writes it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// From when, in seconds since the take-off.
    pub time: f64,
    /// Position along x, m.
    pub x: f64,
    /// Position along y, m.
    pub y: f64,
    /// Height, m.
    pub z: f64,
    /// Yaw, rad.
    pub yaw: f64,
}

/// A mode, as the page writes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Flown {
    /// The closed loop.
    ClosedLoop,
    /// The closed loop and the feed-forward.
    FeedForward,
    /// Sticks.
    Manual,
}

impl From<Flown> for Mode {
    fn from(flown: Flown) -> Self {
        match flown {
            Flown::ClosedLoop => Mode::ClosedLoop,
            Flown::FeedForward => Mode::FeedForward,
            Flown::Manual => Mode::Manual,
        }
    }
}

/// Requests of the page.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum Ask {
    /// To be allowed to command.
    Claim {
        /// The token of the address that the program printed.
        token: String,
        /// True to take the right from another client.
        #[serde(default)]
        force: bool,
    },
    /// To command no more.
    Release,
    /// To know how long the way to the server and back is: the number comes back.
    Ping {
        /// Any number.
        number: f64,
    },
    /// Stops the motors: anybody with the token may.
    Stop,
    /// Makes ready for a flight.
    Arm,
    /// Takes off.
    TakeOff,
    /// Lands.
    Land,
    /// Changes the mode.
    Mode {
        /// To which.
        mode: Flown,
    },
    /// Moves the sticks.
    Sticks {
        /// Roll, rad.
        roll: f64,
        /// Pitch, rad.
        pitch: f64,
        /// Rate of yaw, rad/s.
        yaw_rate: f64,
        /// Rate of climb, m/s.
        climb: f64,
    },
    /// Flies a trajectory.
    Fly {
        /// Its set points, in the order of their times.
        points: Vec<Point>,
    },
    /// Sets a parameter.
    Set {
        /// Its number.
        number: u8,
        /// Its value.
        value: f64,
    },
    /// Chooses what comes down.
    Choose {
        /// Every so many periods.
        every: u8,
        /// The numbers of the signals: up to 36.
        signals: Vec<u8>,
    },
    /// Does something to the simulated aircraft.
    Inject {
        /// Fault to inject.
        injection: Injection,
    },
    /// Kills the onboard software, which is then started anew.
    Kill,
    /// Makes the link worse, or better: probabilities, and a delay in s.
    Link {
        /// Datagrams are lost.
        loss: f64,
        /// They come twice.
        duplication: f64,
        /// They are overtaken.
        reordering: f64,
        /// They are late, s.
        delay: f64,
    },
    /// Begins to record.
    Record,
    /// Ends the recording.
    Save,
    /// Shows a flight that is over so many times as fast; 0 stands still.
    Play {
        /// Speed, in seconds of the recording per second.
        speed: f64,
    },
    /// Goes to a time of it.
    Seek {
        /// Since the testbed began, s.
        time: f64,
    },
}

impl Ask {
    /// Returns true if the request needs no right to command.
    pub fn is_free(&self) -> bool {
        matches!(self, Self::Claim { .. } | Self::Release | Self::Ping { .. })
    }
}

/// Messages to the page.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Tell {
    /// Constants of the session, sent first.
    Hello {
        /// The signals that there are.
        signals: &'static [Signal],
        /// The parameters that there are.
        parameters: Vec<Parameter>,
        /// The parts of a flight, by their numbers.
        phases: Vec<String>,
        /// The alarms, by their numbers.
        alarms: Vec<String>,
        /// True if commands are sealed.
        authenticated: bool,
        /// Limits of trajectories: along x and y, and of the height, m.
        space: [f64; 3],
        /// The control period, s.
        period: f64,
    },
    /// One record that came down.
    Frame {
        /// When, by the onboard software's periods.
        period: u32,
        /// The numbers of the signals.
        signals: Vec<u8>,
        /// Their values.
        values: Vec<f32>,
        /// True state of the simulated aircraft: x, y, z, roll, pitch, yaw.
        truth: [f32; 6],
    },
    /// State of the testbed.
    State(Box<State>),
    /// Position of the player in a recorded flight.
    Playing(Playing),
    /// Right of this page to command.
    Command {
        /// True if this page has the right.
        granted: bool,
        /// Why not.
        reason: &'static str,
    },
    /// Result of a command.
    Outcome {
        /// The order.
        order: String,
        /// Result of the command.
        outcome: Outcome,
    },
    /// A request of the page was malformed or not allowed.
    Refused {
        /// Why.
        reason: String,
    },
    /// The answer to a ping.
    Pong {
        /// The number that came with it.
        number: f64,
    },
}

/// Position of the player in a recorded flight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Playing {
    /// The beginning of the recording, s.
    pub from: f64,
    /// Its end, s.
    pub to: f64,
    /// Time in the recording, s.
    pub time: f64,
    /// Speed of the player; 0 while paused.
    pub speed: f64,
}

/// State of the testbed, sent four times a second.
#[derive(Clone, Debug, Default, Serialize)]
pub struct State {
    /// Time since the testbed began, s.
    pub time: f64,
    /// True if the onboard software answers its bus.
    pub alive: bool,
    /// Number of restarts of the onboard software.
    pub restarts: u64,
    /// Time since the last packet of the downlink, s.
    pub silence: Option<f64>,
    /// Statistics of the period's timing.
    pub timing: Timing,
    /// Fate of the uplink's datagrams.
    pub up: Counts,
    /// Fate of the downlink's datagrams.
    pub down: Counts,
    /// Statistics of the downlink in the station.
    pub heard: Down,
    /// Numbers of packets on board: accepted, corrupt, outdated, invalid, unsealed, forged, replayed; records lost.
    pub counts: Option<[u32; 8]>,
    /// The mode's number.
    pub mode: Option<u8>,
    /// The parameters, as far as they are known.
    pub parameters: Vec<Option<f64>>,
    /// Pages that look on.
    pub pages: usize,
    /// True if any client has the right to command.
    pub commanded: bool,
    /// Messages that were left out for pages that read too slowly.
    pub skipped: u64,
    /// Messages that tools kept out: over MAVLink, unsigned, forged, or said once more.
    pub refused: u64,
    /// State of the recording.
    pub recording: Recording,
}

/// State of a recording.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Recording {
    /// True while recording.
    pub running: bool,
    /// Periods in it.
    pub periods: u64,
    /// Error that ended the recording.
    pub error: Option<String>,
    /// True if a recording can be downloaded.
    pub ready: bool,
}
