//! The IR's interpreter as a leg: it has a component's state, and calls one entry point.

use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::{FunctionId, Module, Owner};

/// A component whose entry point runs in the interpreter.
pub struct Interpreted<'m> {
    interpreter: Interpreter<'m>,
    entry: FunctionId,
    state: Vec<u64>,
}

impl<'m> Interpreted<'m> {
    /// Creates the component of `entry` in its initial state.
    pub fn new(module: &'m Module, entry: FunctionId) -> Interpreted<'m> {
        let state = match module.functions[entry.index()].owner {
            Some(Owner::Struct(id)) => module.structs[id.index()].initial.clone(),
            _ => None,
        };
        let interpreter = Interpreter::new(module);
        Interpreted { interpreter, entry, state: state.unwrap_or_default() }
    }

    /// Calls the entry point; returns the words of the result and of the state.
    ///
    /// # Errors
    ///
    /// The fault.
    pub fn step(&mut self, arguments: &[Vec<u64>]) -> Result<Vec<u64>, Stop> {
        let mut all = vec![self.state.clone()];
        all.extend_from_slice(arguments);
        let mut result = self.interpreter.call(self.entry, &mut all)?;
        self.state.clone_from(&all[0]);
        result.extend_from_slice(&self.state);
        Ok(result)
    }
}
