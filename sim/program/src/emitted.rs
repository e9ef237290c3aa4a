//! The onboard software as C, in a separate process.

use bessemer::Plain;
use bessemer_codegen::compile::Compiled;
use bessemer_legs::process::{Error, Process};
use bessemer_legs::toolchain::Toolchain;
use bessemer_legs::{digest, entry, value};
use models::{Inputs, Outputs, Settings};
use sim::computer::Computer;

/// The emitted C, as a process.
pub struct Emitted {
    process: Process,
    words: Vec<u64>,
}

impl Emitted {
    /// Compiles the C of the models and starts it.
    ///
    /// # Errors
    /// What the compiler or the system said, or that the models have no onboard software.
    pub fn start(compiled: &Compiled, toolchain: &Toolchain) -> Result<Self, Error> {
        let step = entry(compiled, "Onboard", "step")
            .ok_or_else(|| Error::Compile("the models have no `Onboard::step`".into()))?;
        Ok(Self { process: Process::start(compiled, step, toolchain)?, words: Vec::new() })
    }

    /// Restarts the process in the initial state, for another flight.
    ///
    /// # Errors
    ///
    /// An error of the system.
    pub fn restart(&mut self, toolchain: &Toolchain) -> Result<(), Error> {
        self.process.restart(toolchain)
    }
}

impl Computer for Emitted {
    /// # Panics
    /// If the process dies: the flight is over.
    fn step(&mut self, settings: &Settings, inputs: &Inputs) -> Outputs {
        let mut arguments = Vec::with_capacity(512);
        settings.store(&mut |word| arguments.push(word));
        inputs.store(&mut |word| arguments.push(word));
        let results = match self.process.step(&arguments) {
            Ok(results) if results[0] == 0 => results,
            Ok(results) => panic!("the C reports fault {}", results[0]),
            Err(error) => panic!("the C stopped: {error}"),
        };
        self.words = results[1..].to_vec();
        value(&self.words)
    }

    fn digest(&self) -> u64 {
        digest(&self.words)
    }
}
