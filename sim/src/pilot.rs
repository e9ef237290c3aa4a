//! Controllers that can fly the aircraft.
//!
//! The model, its emitted C and the interpreter of its IR implement one trait, so that a flight cannot distinguish
//! them.

use bessemer::Plain;
use models::{Command, Controller, Estimate, Parameters, Target};
use nalgebra::SVector;

/// A controller on any leg.
pub trait Pilot {
    /// Runs one control period.
    fn step(&mut self, estimate: &Estimate, target: &Target) -> Command;

    /// Returns the controller's state as words in order of declaration: an `f64` by its bits, a `bool` as 0 or 1.
    fn state(&self) -> Vec<u64>;
}

/// The model, compiled by rustc.
#[derive(Clone, Debug)]
pub struct Native {
    parameters: Parameters,
    controller: Controller,
}

impl Native {
    /// Creates the controller in its initial state.
    pub fn new(parameters: Parameters) -> Self {
        Self { parameters, controller: Controller::default() }
    }
}

impl Pilot for Native {
    fn step(&mut self, estimate: &Estimate, target: &Target) -> Command {
        self.controller.step(&self.parameters, estimate, target, &SVector::zeros())
    }

    fn state(&self) -> Vec<u64> {
        let mut words = Vec::new();
        self.controller.store(&mut |word| words.push(word));
        words
    }
}
