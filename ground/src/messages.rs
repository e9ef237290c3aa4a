//! The messages to and from the browser: JSON over a WebSocket, each an object with a `type`.
//!
//! Data only. The server checks the sender of each request.

use crate::bench::{Injection, Timing};
use crate::catalogue::{Parameter, Signal};
use crate::events::{Event, Health};
use crate::radio::Counts;
use crate::refusal::Check;
use crate::station::{Down, Outcome};
use models::receiver::Mode;
use serde::{Deserialize, Serialize};
use sim::battery::Battery;
use std::path::Path;
use std::time::UNIX_EPOCH;

/// A setpoint from the page.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Point {
    /// Time since the take-off from which it applies, s.
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

/// A flight mode from the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Flown {
    /// Flies a trajectory with the closed loop alone.
    ClosedLoop,
    /// Flies a trajectory with the closed loop and the feed-forward.
    FeedForward,
    /// Follows the sticks.
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
    /// Requests the right to command.
    Claim {
        /// The token of the address that the program printed.
        token: String,
        /// True to take the right away from another client.
        #[serde(default)]
        force: bool,
    },
    /// Gives the right to command back.
    Release,
    /// Measures the round trip to the server: the number is sent back.
    Ping {
        /// An arbitrary number.
        number: f64,
    },
    /// Stops the motors; any client with the token may do that.
    Stop,
    /// Arms the motors.
    Arm,
    /// Disarms the motors of an aircraft on the ground.
    Disarm,
    /// Takes off.
    TakeOff,
    /// Lands.
    Land,
    /// Changes the mode.
    Mode {
        /// Mode to change to.
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
        /// Setpoints in the order of their times.
        points: Vec<Point>,
    },
    /// Sets a parameter.
    Set {
        /// Number of the parameter.
        number: u8,
        /// New value.
        value: f64,
    },
    /// Selects the signals of the downlink.
    Choose {
        /// Number of periods between two records.
        every: u8,
        /// Numbers of at most 36 signals.
        signals: Vec<u8>,
    },
    /// Injects a fault into the simulated aircraft.
    Inject {
        /// Fault to inject.
        injection: Injection,
    },
    /// Kills the onboard software, which is then restarted.
    Kill,
    /// Changes the quality of the link.
    Link {
        /// Probability that a datagram is lost.
        loss: f64,
        /// Probability that a datagram is delivered twice.
        duplication: f64,
        /// Probability that a datagram is overtaken by later ones.
        reordering: f64,
        /// Delay of all datagrams, s.
        delay: f64,
    },
    /// Starts a recording.
    Record,
    /// Finishes the recording.
    Save,
    /// Sets the speed at which a recorded flight is shown; 0 pauses it.
    Play {
        /// Speed, in seconds of the recording per second.
        speed: f64,
    },
    /// Jumps to a time in a recorded flight.
    Seek {
        /// Time since the testbed began, s.
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
        /// All signals.
        signals: &'static [Signal],
        /// All parameters.
        parameters: Vec<Parameter>,
        /// Number of motors.
        motors: usize,
        /// Largest speed of a motor, rad/s.
        fastest: f64,
        /// Largest force of the wind that the page offers, N.
        wind: f64,
        /// Names of the flight's phases, by number.
        phases: Vec<String>,
        /// Names of the alarms, by number.
        alarms: Vec<String>,
        /// True if commands are sealed.
        authenticated: bool,
        /// Limits of trajectories: along x and y, and of the height, m.
        space: [f64; 3],
        /// The control period, s.
        period: f64,
    },
    /// A record from the downlink.
    Frame {
        /// Number of the onboard software's period.
        period: u32,
        /// The numbers of the signals.
        signals: Vec<u8>,
        /// Values of the signals.
        values: Vec<f32>,
        /// True state of the simulated aircraft: x, y, z, roll, pitch, yaw.
        truth: [f32; 6],
    },
    /// An event of the flight.
    Event(Event),
    /// State of the testbed.
    State(Box<State>),
    /// All of a recorded flight, sent once.
    Flight(Box<Flight>),
    /// Position of the player in a recorded flight.
    Playing(Playing),
    /// Right of this page to command.
    Command {
        /// True if this page has the right.
        granted: bool,
        /// Reason why the right was not granted.
        reason: &'static str,
    },
    /// Result of a command.
    Outcome {
        /// Name of the command.
        order: String,
        /// Result of the command.
        outcome: Outcome,
    },
    /// A request of the page was malformed or not allowed.
    Refused {
        /// Reason for the rejection.
        reason: String,
    },
    /// The answer to a ping.
    Pong {
        /// The number from the ping.
        number: f64,
    },
}

/// A recorded flight, sampled evenly.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Flight {
    /// Time of each sample since the testbed began, s.
    pub times: Vec<f32>,
    /// The numbers of the signals.
    pub signals: Vec<u8>,
    /// Samples of each signal, in the order of the signals.
    pub columns: Vec<Vec<f32>>,
}

/// Position of the player in a recorded flight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Playing {
    /// Start of the recording, s.
    pub from: f64,
    /// End of the recording, s.
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
    /// Counters of the uplink's datagrams.
    pub up: Counts,
    /// Counters of the downlink's datagrams.
    pub down: Counts,
    /// Counters of the packets that the ground station received.
    pub heard: Down,
    /// Counters of packets on board: accepted, corrupt, outdated, invalid, unsealed, forged, replayed; and of lost
    /// records.
    pub counts: Option<[u32; 8]>,
    /// Number of the flight mode.
    pub mode: Option<u8>,
    /// True if a trajectory was sent that no flight has followed yet.
    pub planned: bool,
    /// Battery of the simulated aircraft.
    pub battery: Charge,
    /// Recordings that can be downloaded, the oldest first.
    pub recordings: Vec<Saved>,
    /// State of the aircraft's sensors.
    pub sensors: Vec<Health>,
    /// Checks before arming.
    pub checks: Vec<Check>,
    /// Values of the parameters; `None` for those not received yet.
    pub parameters: Vec<Option<f64>>,
    /// Number of connected pages.
    pub pages: usize,
    /// True if any client has the right to command.
    pub commanded: bool,
    /// Number of messages dropped for pages that read too slowly.
    pub skipped: u64,
    /// Number of MAVLink messages rejected because they were unsigned, forged or repeated.
    pub refused: u64,
    /// State of the recording.
    pub recording: Recording,
}

/// State of a battery.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Charge {
    /// Voltage, V.
    pub voltage: f64,
    /// Remaining share of the charge.
    pub left: f64,
}

impl Charge {
    /// Returns the state of a battery.
    pub fn of(battery: &Battery) -> Self {
        Self { voltage: battery.voltage(), left: battery.left() }
    }
}

/// A finished recording.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Saved {
    /// Name of the file.
    pub name: String,
    /// Size of the file, bytes.
    pub bytes: u64,
    /// Time of its last change, s since 1970; 0 if the system does not say it.
    pub written: f64,
}

impl Saved {
    /// Returns the description of a file; none if its name is no text.
    pub fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?.to_owned();
        let about = path.metadata().ok();
        let written = about.as_ref().and_then(|it| it.modified().ok());
        let written = written.and_then(|it| it.duration_since(UNIX_EPOCH).ok());
        let bytes = about.map_or(0, |it| it.len());
        Some(Self { name, bytes, written: written.map_or(0.0, |it| it.as_secs_f64()) })
    }
}

/// State of a recording.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Recording {
    /// True while recording.
    pub running: bool,
    /// Number of recorded periods.
    pub periods: u64,
    /// Error that ended the recording.
    pub error: Option<String>,
    /// True if a recording can be downloaded.
    pub ready: bool,
}
