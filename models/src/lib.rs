//! The flight software of the reference thesis, for quadcopters and hexacopters.
//!
//! It reads from the outside in:
//!
//! | module | what it says | thesis |
//! |---|---|---|
//! | [`onboard`] | everything that happens in one period | §6.1 |
//! | [`receiver`], [`packet`], [`trajectory`], [`tuning`] | what the ground asks for | §6.1 |
//! | [`gate`], [`siphash`] | whether it is the ground that asks | |
//! | [`calibration`] | from counts to units | §6.1 |
//! | [`estimator`], [`attitude_filter`], [`axis_filter`], [`covariance`], [`low_pass`], [`stuck`], [`expectation`] | what is known of the aircraft | §6.1 |
//! | [`reference_generator`], [`touch_down`] | where it is wanted: take-off, trajectory, sticks, landing | (3.20) |
//! | [`crash_predictor`], [`clock_monitor`] | when to stop the motors | §6.1 |
//! | [`controller`] | the slot for the closed loop | ch. 3 |
//! | [`cascade`], [`printed`], [`geometric`] | the candidates for it | ch. 3 |
//! | [`height`] | how hard to push | (3.14) |
//! | [`horizontal`] | where to lean | (3.16), (3.17) |
//! | [`attitude`] | how to turn | (3.15), (3.18), (3.19) |
//! | [`feed_forward`] | flying as if gravity were another | ch. 4 |
//! | [`mixer`] | what each motor contributes | (3.9), (3.10) |
//! | [`logger`], [`sender`] | what is written down and sent | §6.1 |
//! | [`plant`] | how the aircraft moves | ch. 2 |
//! | [`geometry`] | angles, rates and frames | (2.11), (2.16), (2.17) |
//! | [`airframe`], [`parameters`] | the aircraft in figures | tables A.1, 3.1 |
//!
//! Everything here is also C, bit for bit. So nothing here knows of a simulation, a file or an operating
//! system; what an entry point needs comes in through its arguments.

#![no_std]
// Loops over indices where the C has one, too; and what the DSL has no word for yet.
#![allow(clippy::needless_range_loop, clippy::manual_is_multiple_of, clippy::manual_memcpy)]

pub mod airframe;
pub mod attitude;
pub mod attitude_filter;
pub mod axis_filter;
pub mod calibration;
pub mod cascade;
pub mod clock_monitor;
pub mod controller;
pub mod covariance;
pub mod crash_predictor;
pub mod estimator;
pub mod expectation;
pub mod feed_forward;
pub mod gate;
pub mod geometric;
pub mod geometry;
pub mod height;
pub mod horizontal;
pub mod logger;
pub mod low_pass;
pub mod mixer;
pub mod onboard;
pub mod packet;
pub mod parameters;
pub mod plant;
pub mod printed;
pub mod receiver;
pub mod reference_generator;
pub mod sender;
pub mod signals;
pub mod siphash;
pub mod stuck;
pub mod touch_down;
pub mod trajectory;
pub mod tuning;

pub use airframe::{Airframe, Layout, MOST_MOTORS, Wrench};
pub use attitude::Attitude;
pub use controller::Controller;
pub use crash_predictor::{Alarm, Limits};
pub use estimator::{Estimator, Sensors};
pub use feed_forward::{Injection, Profile};
pub use geometry::Orientation;
pub use height::Height;
pub use mixer::Mixer;
pub use onboard::{Inputs, Onboard, Outputs, Settings};
pub use packet::Packet;
pub use parameters::{Candidate, Damped, Gains, Parameters};
pub use plant::{Motion, Plant};
pub use receiver::Mode;
pub use reference_generator::Phase;
pub use signals::{Command, Estimate, Target};
