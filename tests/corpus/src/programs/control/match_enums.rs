//! `match` on an enum becomes a `switch`, as a value or as a statement.

use bessemer::prelude::*;

/// Phases of a flight.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Phase {
    #[default]
    Ground,
    Climb,
    Cruise,
    Landing,
}

/// Steps through the phases in order.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sequence {
    phase: Phase,
    ticks: u16,
}

#[component]
impl Sequence {
    /// The phase at a height, m.
    #[entry(infallible)]
    pub fn step(&mut self, height: f64, land: bool) -> Phase {
        self.ticks = self.ticks.wrapping_add(1);
        let next = match self.phase {
            Phase::Ground if !land => Phase::Climb,
            Phase::Climb if height > 10.0 => Phase::Cruise,
            Phase::Climb | Phase::Cruise if land => Phase::Landing,
            Phase::Landing if height < 0.05 => Phase::Ground,
            same => same,
        };
        if next != self.phase {
            self.ticks = 0;
            self.phase = next;
        }
        next
    }
}
