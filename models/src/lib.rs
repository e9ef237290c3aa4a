//! The flight software of the reference thesis, for quadcopters and hexacopters.
//!
//! The modules from the outside in:
//!
//! | module | purpose | thesis |
//! |---|---|---|
//! | [`onboard`] | all steps of one period | §6.1 |
//! | [`receiver`], [`packet`], [`trajectory`], [`tuning`] | commands of the ground station | §6.1 |
//! | [`gate`], [`siphash`] | authentication of commands | |
//! | [`calibration`] | conversion of counts to units | §6.1 |
//! | [`estimator`], [`attitude_filter`], [`axis_filter`], [`low_pass`], [`stuck`], [`expectation`] | state estimation | §6.1 |
//! | [`reference_generator`], [`touch_down`] | target: take-off, trajectory, sticks, landing | (3.20) |
//! | [`shaper`] | horizontal set points with limited speed, acceleration and jerk | |
//! | [`crash_predictor`], [`clock_monitor`] | alarms that stop the motors | §6.1 |
//! | [`controller`] | closed loop | ch. 3 |
//! | [`cascade`], [`printed`], [`geometric`] | control laws | ch. 3 |
//! | [`height`] | height control | (3.14) |
//! | [`horizontal`] | horizontal control | (3.16), (3.17) |
//! | [`attitude`] | attitude control | (3.15), (3.18), (3.19) |
//! | [`feed_forward`] | feed-forward that emulates another gravity | ch. 4 |
//! | [`mixer`] | motor commands from thrust and torques | (3.9), (3.10) |
//! | [`logger`], [`sender`] | log and downlink | §6.1 |
//! | [`plant`] | the aircraft's motion | ch. 2 |
//! | [`geometry`] | angles, rates and frames | (2.11), (2.16), (2.17) |
//! | [`airframe`], [`parameters`] | physical parameters and gains | tables A.1, 3.1 |
//!
//! C is generated from everything here and computes the same bits. Simulation, files and operating system are
//! unknown here: each entry point receives its inputs as arguments.

#![no_std]
// Loops over indices are loops over indices in the C; the other two have no counterpart in the DSL.
#![allow(clippy::needless_range_loop, clippy::manual_is_multiple_of, clippy::manual_memcpy)]

pub mod airframe;
pub mod attitude;
pub mod attitude_filter;
pub mod axis_filter;
pub mod calibration;
pub mod cascade;
pub mod clock_monitor;
pub mod controller;
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
pub mod shaper;
pub mod signals;
pub mod siphash;
pub mod stuck;
pub mod touch_down;
pub mod trajectory;
pub mod tuning;

pub use airframe::{Airframe, Layout, MAX_MOTORS, Wrench};
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
