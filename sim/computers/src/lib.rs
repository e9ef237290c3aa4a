//! Computers under test for the closed loops of [`bessemer_sim`]: the same controller, run by something else than rustc.
//!
//! A [`Leg`] takes the words of a call's arguments and returns the words of its result. [`wired`] makes one the
//! [`Computer`] of a loop.
//!
//! | leg | what runs |
//! |---|---|
//! | [`Entry::interpreter`] | the IR, in the interpreter |
//! | [`Entry::process`] | the emitted C, compiled here, in a process of its own; also for an emulated processor |
//! | [`Entry::board`], [`Entry::port`] | the emitted C on a board, over a serial line |
//! | [`Unit`] | a co-simulation unit of FMI 3.0, from this or another tool |
//!
//! The first three run an [`Entry`] of a [`Package`]: the package of models around a folder, compiled as `cargo bessemer` does. Words are
//! those of [`bessemer::Plain`]: the scalars in order, 64 bits each.
//!
//! ```no_run
//! # use bessemer_sim::*;
//! # fn run(setup: Setup<Tank, 1, 1>, scenario: Scenario<f64, ()>) -> Result<(), Box<dyn std::error::Error>> {
//! use bessemer_computers::{Package, host, wired};
//!
//! // Controller::step(&mut self, gain: f64, target: f64, level: f64) -> f64
//! let package = Package::find(env!("CARGO_MANIFEST_DIR"))?;
//! let leg = package.entry("Controller::step")?.process(&host()?)?;
//! let arguments = |[level]: &[Reading; 1], target: &f64| (0.5, *target, level.value);
//! let mut computer = wired(leg, arguments, |valve: f64| valve);
//! let outcome = setup.run(&scenario, &mut computer)?;
//! # Ok(()) }
//! # struct Tank;
//! # impl Plant<1> for Tank {
//! #     type Command = f64;
//! #     type Disturbance = ();
//! #     fn derivative(&self, _: f64, _: &State<1>, input: &Input<f64, ()>) -> State<1> { State::from([input.command]) }
//! # }
//! ```
//!
//! A fault of the controller, a process that died, or a board that does not answer ends the run with an error.
//!
//! [`Computer`]: bessemer_sim::Computer

#![deny(missing_docs)]

mod error;
mod kept;
mod leg;
mod package;
mod unit;

pub use bessemer_legs::toolchain::Toolchain;
pub use error::Error;
pub use kept::{Boarded, Compiled, Interpreted, Kept};
pub use leg::{Leg, Wired, wired};
pub use package::{Entry, Package, host};
pub use unit::Unit;
