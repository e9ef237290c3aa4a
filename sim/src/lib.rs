//! The plant and the flights: desktop Rust, never emitted.
//!
//! | module | what it says |
//! |---|---|
//! | [`vehicle`] | a multicopter with any number of motors: forces and torques |
//! | [`plant`] | its motion: twelve states, RK4, a floor |
//! | [`pilot`] | whatever can fly it: the model, its emitted C, the interpreter of its IR |
//! | [`mission`] | what is asked of the pilot, when, and what air the aircraft meets |
//! | [`flight`] | a pilot flying a mission in closed loop, recorded step by step |
//! | [`report`] | a flight as a person wants to read it |
//! | [`verdict`] | whether the flight settled after each manoeuvre, and landed |
//!
//! The plant shares no code with the model that flies it, save its data: a fault in one must not
//! hide in the other.

pub mod flight;
pub mod mission;
pub mod pilot;
pub mod plant;
pub mod report;
pub mod vehicle;
pub mod verdict;

pub use flight::{Flight, Step, fly};
pub use mission::{Action, Gust, Manoeuvre, Mission};
pub use pilot::{Native, Pilot};
pub use plant::State;
pub use vehicle::{Layout, Vehicle};
pub use verdict::{Fault, Tolerance};
