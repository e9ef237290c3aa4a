//! A state machine whose states carry their data: a pump that is primed, runs, and is locked out when it runs dry.
//!
//! A timer exists only in the state that uses it. An invalid state, after a fault of the memory, counts as locked out.

use bessemer::prelude::*;

/// Duration of priming, ms.
pub const PRIMING_MS: u16 = 3000;
/// Time without flow after which a running pump counts as dry, ms.
pub const DRY_MS: u16 = 500;

/// State of the pump.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum PumpState {
    /// The pump is off.
    #[default]
    Off,
    /// The pump fills the pipe.
    Priming {
        /// Remaining time, ms.
        left: u16,
    },
    /// The pump runs.
    Running {
        /// Time since the last flow, ms.
        dry: u16,
    },
    /// The pump ran dry, and is off until that is acknowledged.
    #[c(fallback)]
    LockedOut,
}

/// Inputs of a period.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PumpInputs {
    /// True if the pump is to run.
    pub demand: bool,
    /// True if the flow switch is closed.
    pub flow: bool,
    /// True if the operator acknowledges the lock-out.
    pub acknowledge: bool,
}

/// Controls a pump.
#[component]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PumpControl {
    state: PumpState,
}

#[component]
impl PumpControl {
    /// One period of 1 ms; returns true if the motor is on.
    #[entry(infallible)]
    pub fn step(&mut self, inputs: &PumpInputs) -> bool {
        self.state = match self.state {
            PumpState::LockedOut if inputs.acknowledge && !inputs.demand => PumpState::Off,
            PumpState::LockedOut => PumpState::LockedOut,
            _ if !inputs.demand => PumpState::Off,
            PumpState::Off => PumpState::Priming { left: PRIMING_MS },
            PumpState::Priming { left: 0 } => PumpState::Running { dry: 0 },
            PumpState::Priming { left } => PumpState::Priming { left: left - 1 },
            PumpState::Running { .. } if inputs.flow => PumpState::Running { dry: 0 },
            PumpState::Running { dry } if dry >= DRY_MS => PumpState::LockedOut,
            PumpState::Running { dry } => PumpState::Running { dry: dry + 1 },
        };
        matches!(self.state, PumpState::Priming { .. } | PumpState::Running { .. })
    }

    /// State of the pump.
    #[entry(infallible)]
    pub fn state(&self) -> PumpState {
        self.state
    }
}
