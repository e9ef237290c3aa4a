//! Names, `&'static str`; in the C they are the checksums of their texts, with a constant each.

use bessemer::prelude::*;

/// Name of the machine.
pub const MACHINE: &str = "hydraulic press";

/// Names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];

/// A signal of a display.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Signal {
    /// The name on the display.
    pub name: &'static str,
    /// Its value.
    pub value: f64,
}

#[data]
impl Signal {
    /// A signal without a value yet.
    pub fn new(name: &'static str) -> Self {
        Signal { name, value: 0.0 }
    }
}

/// Signals that are always there.
const SIGNALS: [Signal; 2] =
    [Signal { name: "pump", value: 1.0 }, Signal { name: "valve", value: 2.0 }];

/// Activity of the machine.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// Nothing.
    Idle,
    /// Pressing.
    Pressing,
    /// Stopped.
    Stopped,
}

#[data]
impl Mode {
    /// The name of the mode.
    pub fn name(self) -> &'static str {
        match self {
            Mode::Idle => "idle",
            Mode::Pressing => "pressing, forwards",
            Mode::Stopped => "stopped: over-temperature",
        }
    }

    /// The mode of a name.
    pub fn of(name: &str) -> Option<Mode> {
        match name {
            "idle" => Some(Mode::Idle),
            "pressing, forwards" | "press" => Some(Mode::Pressing),
            _ => None,
        }
    }
}

/// The state of a display.
#[component]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Display {
    /// Signal on the display.
    pub shown: Signal,
    /// Reason of the last fault.
    pub reason: Option<&'static str>,
    /// The mode.
    pub mode: Mode,
}

impl Default for Display {
    fn default() -> Self {
        Display {
            shown: Signal { name: "nothing", value: 0.0 },
            reason: None,
            mode: Mode::Idle,
        }
    }
}

/// Positive numbers, or the reason.
#[function]
fn positive(value: f64) -> Result<f64, &'static str> {
    if value.is_nan() {
        return Err("not a number");
    }
    if value > 0.0 { Ok(value) } else { Err("not positive") }
}

#[component]
impl Display {
    /// Shows a value under the name of the mode.
    #[entry]
    pub fn show(&mut self, mode: Mode, value: f64) -> bool {
        if self.mode != mode {
            self.shown = Signal::new(mode.name());
        }
        self.mode = mode;
        match positive(value) {
            Ok(value) => self.shown.value = value,
            Err(reason) => self.reason = Some(reason),
        }
        self.shown.name == "idle"
    }

    /// The reason of the last fault.
    #[entry]
    pub fn reason(&self) -> &'static str {
        self.reason.unwrap_or("")
    }
}

/// The name of an axis.
#[function]
pub fn axis(index: usize) -> &'static str {
    AXES[index % 3]
}

/// The value of a signal by its name.
#[function]
pub fn value(index: usize) -> Option<f64> {
    let name = if index % 2 == 0 { "pump" } else { "motor" };
    let found = SIGNALS.iter().find(|signal| signal.name == name)?;
    Some(found.value)
}

/// The mode that the name of a mode denotes.
#[function]
pub fn there_and_back(mode: Mode) -> Option<Mode> {
    Mode::of(mode.name())
}

/// Comparison of names from outside.
#[function]
pub fn same(one: &'static str, other: &str) -> [bool; 4] {
    let local: &str = "°C";
    [one == other, one != other, other == MACHINE, local == one || other.is_empty()]
}
