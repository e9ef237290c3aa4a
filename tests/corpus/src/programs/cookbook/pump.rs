//! A state machine whose states carry what they need: a pump that is primed, runs, and is locked out when it runs dry.
//!
//! One `match` says for each state what ends it; no timer outlives the state that it belongs to.

use bessemer::prelude::*;

/// Milliseconds that priming takes.
pub const PRIMING_MS: u16 = 3000;
/// Milliseconds without flow after which a running pump is dry.
pub const DRY_MS: u16 = 500;

/// State of the pump.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum PumpState {
    /// It stands still.
    #[default]
    Off,
    /// It fills the pipe, for so many milliseconds more.
    Priming { left: u16 },
    /// It runs; milliseconds since flow was last seen.
    Running { dry: u16 },
    /// It ran dry, and stays off until that is acknowledged.
    LockedOut,
}

/// Inputs of a period.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PumpInputs {
    /// True if it is to run.
    pub demand: bool,
    /// True if the flow switch is closed.
    pub flow: bool,
    /// True if the operator acknowledges the lock-out.
    pub acknowledge: bool,
}

/// Runs a pump.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PumpControl {
    state: PumpState,
}

#[component]
impl PumpControl {
    /// One period of 1 ms: whether the motor is on.
    #[entry(infallible)]
    pub fn step(&mut self, inputs: &PumpInputs) -> bool {
        self.state = match self.state {
            PumpState::LockedOut if inputs.acknowledge && !inputs.demand => PumpState::Off,
            PumpState::LockedOut => PumpState::LockedOut,
            _ if !inputs.demand => PumpState::Off,
            PumpState::Off => PumpState::Priming { left: PRIMING_MS },
            PumpState::Priming { left: 0 } => PumpState::Running { dry: 0 },
            PumpState::Priming { left } => PumpState::Priming { left: left.saturating_sub(1) },
            PumpState::Running { .. } if inputs.flow => PumpState::Running { dry: 0 },
            PumpState::Running { dry } if dry >= DRY_MS => PumpState::LockedOut,
            PumpState::Running { dry } => PumpState::Running { dry: dry.saturating_add(1) },
        };
        matches!(self.state, PumpState::Priming { .. } | PumpState::Running { .. })
    }

    /// State of the pump.
    #[entry(infallible)]
    pub fn state(&self) -> PumpState {
        self.state
    }
}
