//! An author chooses the variant as which an invalid value counts in the C. For a variant, nothing changes.

use bessemer::prelude::*;

/// Direction of a drive.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Direction {
    /// Forwards.
    Forwards,
    /// No torque: also for a value that is no direction.
    #[default]
    #[c(fallback)]
    Neutral,
    /// Backwards.
    Backwards,
}

/// State of a machine, with numbers as on the wire.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Phase {
    /// Stopped.
    #[c(fallback, name = "PHASE_SAFE")]
    Stopped = 7,
    /// Running.
    #[default]
    Running = 9,
}

/// Drive.
#[component]
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FallbackDrive {
    /// Phase.
    pub phase: Phase,
}

#[component]
impl FallbackDrive {
    /// Torque of a direction.
    #[entry(infallible)]
    pub fn torque(&self, direction: Direction) -> f64 {
        match direction {
            Direction::Forwards => 1.0,
            Direction::Neutral => 0.0,
            Direction::Backwards => -1.0,
        }
    }

    /// Tells whether the drive may move, and stops it in neutral.
    #[entry(infallible)]
    pub fn moves(&mut self, direction: Direction) -> bool {
        match direction {
            Direction::Neutral => {
                self.phase = Phase::Stopped;
                false
            }
            _ => match self.phase {
                Phase::Stopped => false,
                Phase::Running => true,
            },
        }
    }

    /// Counts passes until neutral.
    #[entry(infallible)]
    pub fn passes(&self, directions: [Direction; 4]) -> u32 {
        let mut passes = 0_u32;
        for direction in directions {
            match direction {
                Direction::Neutral => break,
                Direction::Forwards => passes = passes.saturating_add(1),
                Direction::Backwards => passes = passes.saturating_add(10),
            }
        }
        passes
    }
}
