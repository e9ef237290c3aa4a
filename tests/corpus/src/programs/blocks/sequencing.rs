//! A pump as a state machine with entry and exit actions, and tasks at several rates.

use bessemer::prelude::*;
pub use bessemer_blocks::{Actions, Machine, Rates, Schedule, Task};

/// States of the pump.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Phase {
    /// Everything is off.
    #[default]
    Off,
    /// The valve is open; the motor waits.
    Priming,
    /// The motor runs.
    Pumping,
}

/// Inputs and outputs of the pump.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pump {
    /// True if water is wanted.
    pub wanted: bool,
    /// True to open the valve.
    pub valve: bool,
    /// True to run the motor.
    pub motor: bool,
    /// Number of starts of the motor.
    pub starts: u32,
}

#[data]
impl Actions<Phase> for Pump {
    fn next(&mut self, state: Phase, periods: u32) -> Phase {
        match state {
            _ if !self.wanted => Phase::Off,
            Phase::Off => Phase::Priming,
            Phase::Priming if periods >= 20 => Phase::Pumping,
            Phase::Priming => Phase::Priming,
            Phase::Pumping => Phase::Pumping,
        }
    }

    fn enter(&mut self, state: Phase) {
        self.valve = state != Phase::Off;
        if state == Phase::Pumping {
            self.motor = true;
            self.starts = self.starts.saturating_add(1);
        }
    }

    fn exit(&mut self, state: Phase) {
        if state == Phase::Pumping {
            self.motor = false;
        }
    }
}

/// The tasks: each step, every fifth, and every tenth; no step takes more than 90 µs.
const SCHEDULE: Schedule<3> = Schedule {
    tasks: [
        Task { period: 1, phase: 0, cost: 40 },
        Task { period: 5, phase: 1, cost: 30 },
        Task { period: 10, phase: 2, cost: 50 },
    ],
};
const _: () = assert!(SCHEDULE.heaviest() <= 90);

/// Runs the pump every fifth step.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Station {
    rates: Rates<3>,
    machine: Machine<Phase>,
    pump: Pump,
    level: f32,
}

#[component]
impl Station {
    /// Advances one step; returns the pump's outputs.
    #[entry(infallible)]
    pub fn step(&mut self, level: f32) -> Pump {
        let [always, pump_is_due, display_is_due] = self.rates.step(&SCHEDULE);
        if always {
            self.level += 0.1 * (level - self.level);
        }
        if pump_is_due {
            self.pump.wanted = self.level < 1.0;
            self.machine.step(&mut self.pump);
        }
        if display_is_due {
            self.level = self.level.max(0.0);
        }
        self.pump
    }
}
