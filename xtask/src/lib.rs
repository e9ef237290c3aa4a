//! The project's commands, as `cargo xtask …`.
//!
//! A thin face: it finds the tools that a command needs, runs the stages one after another and says what it does.
//! The computation of a stage lives elsewhere (`codegen`, `sim`, the tests).
//!
//! Invariants:
//! - nothing is installed unless `--install` was given;
//! - a failure is one [`error::Error`], with what to do about it where that is known;
//! - the machine is seen only through [`tools::Machine`], so that every decision can be tested on a made-up one;
//! - colour and movement only on a terminal; a pipe gets plain lines.
//!
//! What it must not know: the DSL, the IR, C.

pub mod alternate;
pub mod args;
pub mod bench;
pub mod book;
pub mod doctor;
pub mod error;
pub mod fuzz;
pub mod generate;
pub mod hand_over;
pub mod install;
pub mod mutate;
pub mod project;
pub mod runner;
pub mod stages;
pub mod test;
pub mod tools;
