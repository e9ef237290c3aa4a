//! The names and units of signals and parameters, and the ranges of parameters.
//!
//! The numbers are those of the models; the names are only for people.

use models::tuning::{
    FIRST_GROUND_ONLY, HEXACOPTER_LARGEST_VALUES, HEXACOPTER_LEAST_VALUES, LARGEST_VALUES,
    LEAST_VALUES, PARAMETER_COUNT,
};
use serde::Serialize;
use sim::Aircraft;

/// A signal that the onboard logger can record.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Signal {
    /// Number of the signal on board.
    pub number: u8,
    /// Name of the signal.
    pub name: &'static str,
    /// Unit of the signal.
    pub unit: &'static str,
}

macro_rules! signals {
    ($($number:literal $name:literal $unit:literal;)*) => {
        &[$(Signal { number: $number, name: $name, unit: $unit }),*]
    };
}

/// Every signal.
pub const SIGNALS: &[Signal] = signals! {
    0 "x" "m"; 1 "y" "m"; 2 "z" "m";
    3 "roll" "rad"; 4 "pitch" "rad"; 5 "yaw" "rad";
    6 "vx" "m/s"; 7 "vy" "m/s"; 8 "vz" "m/s";
    9 "p" "rad/s"; 10 "q" "rad/s"; 11 "r" "rad/s";
    12 "wanted x" "m"; 13 "wanted y" "m"; 14 "wanted z" "m"; 15 "wanted yaw" "rad";
    16 "phase" ""; 17 "time" "s";
    18 "closed loop 1" "rad/s"; 19 "closed loop 2" "rad/s"; 20 "closed loop 3" "rad/s";
    21 "closed loop 4" "rad/s"; 22 "closed loop 5" "rad/s"; 23 "closed loop 6" "rad/s";
    24 "closed loop 7" "rad/s"; 25 "closed loop 8" "rad/s";
    26 "feed-forward 1" "rad/s"; 27 "feed-forward 2" "rad/s"; 28 "feed-forward 3" "rad/s";
    29 "feed-forward 4" "rad/s"; 30 "feed-forward 5" "rad/s"; 31 "feed-forward 6" "rad/s";
    32 "feed-forward 7" "rad/s"; 33 "feed-forward 8" "rad/s";
    34 "gain" ""; 35 "alarm" "";
    36 "motor 1" ""; 37 "motor 2" ""; 38 "motor 3" ""; 39 "motor 4" "";
    40 "motor 5" ""; 41 "motor 6" ""; 42 "motor 7" ""; 43 "motor 8" "";
    44 "wanted vx" "m/s"; 45 "wanted vy" "m/s"; 46 "wanted vz" "m/s";
    47 "inertial age" "s"; 48 "Vicon age" "s"; 49 "height age" "s"; 50 "plane age" "s";
    51 "variance x" "m²"; 52 "variance y" "m²"; 53 "variance z" "m²";
    54 "variance roll" "rad²"; 55 "variance pitch" "rad²"; 56 "variance yaw" "rad²";
};

/// Signals of the position in the room.
pub const PLACE: [u8; 3] = [0, 1, 2];
/// Signals of roll, pitch and yaw.
pub const ANGLES: [u8; 3] = [3, 4, 5];
/// Signals of the velocity in the room.
pub const VELOCITY: [u8; 3] = [6, 7, 8];
/// Signals of the turn rates about the body's axes.
pub const RATES: [u8; 3] = [9, 10, 11];
/// Signal of the yaw setpoint.
pub const WANTED_YAW: u8 = 15;
/// Signal of the flight's phase.
pub const PHASE: u8 = 16;
/// Signal of the time since the take-off.
pub const TIME: u8 = 17;
/// Signal of the alarm.
pub const ALARM: u8 = 35;
/// Signals of the age of Vicon's last measurement, and of the height's.
pub const AGES: [u8; 2] = [48, 49];

/// Number of the signal without a meaning, which fills a selection.
pub const UNUSED: u8 = 63;

/// Signals shown on the page for an aircraft of four motors.
///
/// These are state, target, closed loop and feed-forward of each motor, variances, and the ages of Vicon and height.
pub const PAGE_SIGNALS: [u8; 36] = [
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 26, 27, 28, 29,
    34, 35, 48, 49, 51, 52, 53, 54, 55, 56,
];

/// Signals shown on the page for an aircraft of six motors, whose only variance is the height's.
const HEXACOPTER_PAGE_SIGNALS: [u8; 36] = [
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 26, 27,
    28, 29, 30, 31, 34, 35, 48, 49, 53, UNUSED,
];

/// Returns the signals shown on the page for an aircraft.
pub fn page_signals(aircraft: Aircraft) -> [u8; 36] {
    match aircraft {
        Aircraft::Mambo => PAGE_SIGNALS,
        Aircraft::F550 => HEXACOPTER_PAGE_SIGNALS,
    }
}

/// A parameter that the ground station can change.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Parameter {
    /// Number of the parameter on board.
    pub number: u8,
    /// Name of the parameter.
    pub name: &'static str,
    /// Unit of the parameter.
    pub unit: &'static str,
    /// Lower limit of the value.
    pub least: f64,
    /// Upper limit of the value.
    pub most: f64,
    /// Value at the start.
    pub initial: f64,
    /// True if the parameter can be changed in flight.
    pub in_flight: bool,
    /// Names of its values 0, 1 …; empty if the values are numbers.
    pub choices: &'static [&'static str],
}

/// Name and unit of each parameter, in the order of `models::tuning`.
const NAMED: [(&str, &str); PARAMETER_COUNT] = [
    ("height P", "N/m"),
    ("height I", "N/(m·s)"),
    ("height D", "N·s/m"),
    ("roll P", "N·m/rad"),
    ("roll I", "N·m/(rad·s)"),
    ("roll D", "N·m·s/rad"),
    ("pitch P", "N·m/rad"),
    ("pitch I", "N·m/(rad·s)"),
    ("pitch D", "N·m·s/rad"),
    ("yaw P", "N·m/rad"),
    ("yaw D", "N·m·s/rad"),
    ("x P", "rad/m"),
    ("x D", "rad·s/m"),
    ("y P", "rad/m"),
    ("y D", "rad·s/m"),
    ("feed-forward gain", ""),
    ("friction taken away", "N·s/m"),
    ("rate of landing", "m/s"),
    ("take-off excess", ""),
    (CANDIDATE, ""),
    ("speed of set points", "m/s"),
    ("acceleration of set points", "m/s²"),
    ("jerk of set points", "m/s³"),
];

/// Name of the parameter that selects the control law; its values are the numbers of `models::Candidate`.
const CANDIDATE: &str = "candidate";
const CANDIDATES: [&str; 3] = ["cascade", "as printed", "geometric"];

/// Returns the least and the largest value of each parameter of an aircraft.
fn ranges(aircraft: Aircraft) -> [&'static [f64; PARAMETER_COUNT]; 2] {
    match aircraft {
        Aircraft::Mambo => [&LEAST_VALUES, &LARGEST_VALUES],
        Aircraft::F550 => [&HEXACOPTER_LEAST_VALUES, &HEXACOPTER_LARGEST_VALUES],
    }
}

/// Returns every parameter of an aircraft.
pub fn parameters(aircraft: Aircraft) -> Vec<Parameter> {
    let (settings, [least, largest]) = (aircraft.settings(), ranges(aircraft));
    let named = NAMED.iter().enumerate();
    named
        .map(|(n, (name, unit))| Parameter {
            number: n as u8,
            name,
            unit,
            least: least[n],
            most: largest[n],
            initial: settings.parameter(n as u8),
            in_flight: n < FIRST_GROUND_ONLY,
            choices: if *name == CANDIDATE { &CANDIDATES } else { &[] },
        })
        .collect()
}
