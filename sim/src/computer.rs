//! A computer that runs the onboard software: the models as compiled by rustc here; their C elsewhere.
//!
//! A flight cannot distinguish them.

use bessemer_words::{digest, words};
use models::{Inputs, Onboard, Outputs, Settings};

/// An onboard computer.
pub trait Computer {
    /// Runs one control period.
    fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs;

    /// Returns the [`digest`] of all outputs of the last period and of the state after it, as words in the order of
    /// declaration.
    fn digest(&self) -> u64;
}

/// The models, compiled by rustc.
#[derive(Clone, Debug, Default)]
pub struct Native {
    onboard: Onboard,
    outputs: Outputs,
}

impl Native {
    /// Returns the words of the last period's outputs and of the state after it.
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
