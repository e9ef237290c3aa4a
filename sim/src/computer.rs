//! Whatever can run the onboard software: here the models as rustc compiles them; their C is another.
//!
//! No flight can tell which of them it has on board.

use bessemer_words::{digest, words};
use models::{Inputs, Onboard, Outputs, Settings};

/// An onboard computer.
pub trait Computer {
    /// One control period.
    fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs;

    /// Returns the [`digest`] of all outputs of the last period and of the state after it, as words in the order of
    /// declaration.
    fn digest(&self) -> u64;
}

/// The models, as rustc compiles them.
#[derive(Clone, Debug, Default)]
pub struct Native {
    onboard: Onboard,
    outputs: Outputs,
}

impl Native {
    /// The words of what it said in the last period and of what it remembers after it.
    pub fn words(&self) -> Vec<u64> {
        [words(&self.outputs), words(&self.onboard)].concat()
    }
}

impl Computer for Native {
    fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs {
        self.outputs = self.onboard.step(settings, inputs);
        self.outputs
    }

    fn digest(&self) -> u64 {
        digest(&self.words())
    }
}
