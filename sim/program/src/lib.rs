//! The flight software as C in the simulated world, for the program that flies.
//!
//! | module | what it says |
//! |---|---|
//! | [`emitted`] | the C of the models, as a process |
//! | [`board`] | the same on a machine of its own, behind a serial line |
//!
//! The world itself is the package `sim`, which knows no compiler: a change there does not build it again.

pub mod board;
pub mod emitted;
