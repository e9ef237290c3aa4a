//! The flight software of the reference thesis: a closed-loop controller for the Parrot Mambo.
//!
//! It reads from the outside in:
//!
//! | module | what it says | thesis |
//! |---|---|---|
//! | [`controller`] | one control period, from what is sensed to what the motors get | ch. 3 |
//! | [`height`] | how hard to push | (3.14) |
//! | [`horizontal`] | where to lean | (3.16), (3.17) |
//! | [`attitude`] | how to turn | (3.15), (3.18), (3.19) |
//! | [`mixer`] | what each motor contributes | (3.9), (3.10) |
//! | [`geometry`] | angles, rates and frames | (2.11), (2.16), (2.17) |
//! | [`airframe`], [`parameters`] | the Mambo in figures | tables A.1, 3.1 |
//!
//! Everything here is also C, bit for bit. So nothing here knows of a plant, a simulation, a file or
//! an operating system; what an entry point needs comes in through its arguments.

#![no_std]

pub mod airframe;
pub mod attitude;
pub mod controller;
pub mod geometry;
pub mod height;
pub mod horizontal;
pub mod mixer;
pub mod parameters;
pub mod signals;

pub use airframe::Airframe;
pub use attitude::Attitude;
pub use controller::Controller;
pub use geometry::Orientation;
pub use height::Height;
pub use mixer::Mixer;
pub use parameters::{Damped, Gains, Parameters};
pub use signals::{Command, Sensed, Target};
