//! The flight's controller on any leg, behind the simulation's trait.

use bessemer_codegen::compile::Compiled;
use bessemer_ir::FunctionId;
pub use bessemer_legs::entry;
use models::{Command, Estimate, Parameters, Target};
use sim::Pilot;

use crate::interpreter::Interpreted;
use crate::process::{Error, Process};
use crate::toolchain::Toolchain;
use crate::{value, words};

enum Leg<'m> {
    Interpreter(Interpreted<'m>),
    C(Box<Process>),
}

/// A pilot whose controller runs in the interpreter or as C.
pub struct Wired<'m> {
    leg: Leg<'m>,
    parameters: Vec<u64>,
    state: Vec<u64>,
}

impl<'m> Wired<'m> {
    /// Creates a pilot with the controller in the interpreter.
    pub fn interpreted(compiled: &'m Compiled, entry: FunctionId, parameters: &Parameters) -> Self {
        let leg = Leg::Interpreter(Interpreted::new(&compiled.module, entry));
        Wired { leg, parameters: words(parameters), state: Vec::new() }
    }

    /// Creates a pilot with the controller as C.
    ///
    /// # Errors
    ///
    /// An error of the compiler or of the system.
    pub fn c(
        compiled: &Compiled,
        entry: FunctionId,
        toolchain: &Toolchain,
        parameters: &Parameters,
    ) -> Result<Self, Error> {
        let leg = Leg::C(Box::new(Process::start(compiled, entry, toolchain)?));
        Ok(Wired { leg, parameters: words(parameters), state: Vec::new() })
    }
}

impl Pilot for Wired<'_> {
    /// # Panics
    /// If the leg faults or dies: the flight is over.
    fn step(&mut self, estimate: &Estimate, target: &Target) -> Command {
        let arguments = [self.parameters.clone(), words(estimate), words(target), vec![0; 8]];
        let results = match &mut self.leg {
            Leg::Interpreter(leg) => match leg.step(&arguments) {
                Ok(results) => results,
                Err(stop) => panic!("the interpreter stopped: {stop}"),
            },
            Leg::C(process) => match process.step(&arguments.concat()) {
                Ok(results) if results[0] == 0 => results[1..].to_vec(),
                Ok(results) => panic!("the C reports fault {}", results[0]),
                Err(error) => panic!("the C stopped: {error}"),
            },
        };
        let command: Command = value(&results);
        self.state = results[words(&command).len()..].to_vec();
        command
    }

    fn state(&self) -> Vec<u64> {
        self.state.clone()
    }
}
