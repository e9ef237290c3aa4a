//! The computer under test: a controller, whoever runs it.
//!
//! A run cannot distinguish a closure from a process or a board: a step takes readings and a goal, and returns a command
//! or an error.

use crate::sensor::Reading;

/// Error of a computer: a process that died, a board that did not answer.
pub type Failure = Box<dyn std::error::Error + Send + Sync>;

/// A computer that reads S sensors and follows goals G with commands C.
///
/// A closure `FnMut(&[Reading; S], &G) -> C` is a computer; so is a Rust model in one. A controller that runs in a
/// process or on a board implements the trait, and returns what goes wrong there as a [`Failure`].
pub trait Computer<const S: usize, G, C> {
    /// Runs one control period.
    ///
    /// # Errors
    ///
    /// The computer cannot answer.
    fn step(&mut self, readings: &[Reading; S], goal: &G) -> Result<C, Failure>;
}

impl<const S: usize, G, C, F: FnMut(&[Reading; S], &G) -> C> Computer<S, G, C> for F {
    fn step(&mut self, readings: &[Reading; S], goal: &G) -> Result<C, Failure> {
        Ok(self(readings, goal))
    }
}
