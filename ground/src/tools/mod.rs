//! External tools: Foxglove, and ground stations that use MAVLink.
//!
//! Each is a feature of this package, since its dependencies are larger than the rest of the ground station.
//! Invariant: a tool never makes the testbed wait.

#[cfg(feature = "foxglove")]
pub mod foxglove;
#[cfg(feature = "mavlink")]
pub mod mavlink;

use crate::bench::Period;
use crate::command::Seat;
use crate::events::Event;
use crate::messages::Ask;
use crate::refusal::Situation;
use crate::testbed::Testbed;
use sim::ground_station::News;

/// A tool at the testbed's side.
pub trait Tool {
    /// Returns the requests since the last call. Those that need the right to command are made only by the client that
    /// has it, and one that would be refused may be answered by the tool, too.
    fn listen(&mut self, _testbed: &Testbed, _now: &Situation, _seat: &Seat) -> Vec<Ask> {
        Vec::new()
    }

    /// Returns the number of rejected messages.
    fn refused(&self) -> u64 {
        0
    }

    /// Reports an event of the flight.
    fn report(&mut self, _event: &Event) {}

    /// Reports the results of a period, and the state of the flight before it.
    fn tell(&mut self, testbed: &Testbed, before: &Situation, done: &Period, news: &[News]);
}
