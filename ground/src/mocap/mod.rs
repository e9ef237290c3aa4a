//! Motion capture over NatNet, the protocol of OptiTrack's Motive: a receiver for the testbed, and a server that streams
//! the simulated aircraft.
//!
//! The receiver replaces the simulated Vicon of the bench. The server is the other end for its tests, and for programs of
//! others that expect a motion-capture system.
//!
//! Invariants: a pose that is not tracked, not finite or not newer than the last one never reaches the aircraft, and nothing
//! here waits during a flight in real time.

mod pose;
mod receiver;
mod server;

pub use pose::pose;
pub use receiver::{Counts, Error, Receiver, Source};
pub use server::Server;

/// Name of the body that is the aircraft, unless another one is requested.
pub const BODY: &str = "aircraft";

/// Axis of the motion-capture system that points upwards.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// The y axis, as Motive has it unless it is changed there: the room's y is its -z.
    #[default]
    Y,
    /// The z axis, as in the room.
    Z,
}
