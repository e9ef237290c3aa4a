//! Interpreter of the IR: the third leg beside native Rust and the emitted C.
//!
//! Arguments and results are words, in the order of [`Module::leaves`]. Operations have Rust's meaning; where Rust
//! leaves bits open (`min` of zeros, a NaN's sign), the DSL's.
//!
//! Invariants:
//!
//! * The module was validated; otherwise calls may panic.
//! * Evaluation is strictly left to right, operands before the operation.
//! * A payload is read only while its variant is there. Its words exist otherwise too, so the C's results would not show it.
//! * A function call does not allocate, once the memory is large enough.
//!
//! Must not have: C, passes, or an optimisation that could change an order. It must stay small enough to be verified
//! by reading.

mod kernel;
mod layout;
mod routine;
mod run;
mod scalar;

use std::collections::BTreeSet;

use bessemer_ir::{Fault, FunctionId, Mode, Module, Span};

use bessemer_ir::words::{WordsError, words_fit};
use layout::Layout;

/// Reasons why a call returned no result.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Stop {
    /// A fault, where Rust would panic.
    #[error("{fault:?} in function {} at {}:{}:{}", function.0, span.file, span.line, span.column)]
    Fault {
        /// Kind of the fault.
        fault: Fault,
        /// Function with the fault: the called one, or a callee.
        function: FunctionId,
        /// Span of the operation.
        span: Span,
    },
    /// A payload was read whose variant is not there: a defect of what generated the IR.
    #[error("a payload of another variant is read in function {} at {}:{}:{}", function.0, span.file, span.line, span.column)]
    Absent {
        /// Function that reads it.
        function: FunctionId,
        /// Span of the value.
        span: Span,
    },
    /// The call took more statements than [`Interpreter::limit`] allows.
    #[error("the call takes too many statements")]
    Limit,
    /// The module has no such function.
    #[error("there is no function {}", .0.0)]
    Function(FunctionId),
    /// The number of arguments is wrong.
    #[error("the function takes {expected} arguments, not {found}")]
    Arguments {
        /// Number of parameters.
        expected: usize,
        /// Number of arguments.
        found: usize,
    },
    /// An argument is not a value of its parameter's type.
    #[error("argument {index}: {problem}")]
    Argument {
        /// Index of the argument.
        index: usize,
        /// Error in its words.
        problem: WordsError,
    },
}

/// Calls `function` of a validated module; see [`Interpreter::call`].
pub fn call(
    module: &Module,
    function: FunctionId,
    arguments: &mut [Vec<u64>],
) -> Result<Vec<u64>, Stop> {
    Interpreter::new(module).call(function, arguments)
}

/// Runs functions of a validated module, and reuses its memory between calls.
pub struct Interpreter<'m> {
    module: &'m Module,
    layout: Layout,
    memory: Vec<u64>,
    limit: u64,
    ran: Option<BTreeSet<Span>>,
}

impl<'m> Interpreter<'m> {
    /// Creates an interpreter of `module`, which must have been validated.
    pub fn new(module: &'m Module) -> Interpreter<'m> {
        let layout = Layout::new(module);
        Interpreter { module, layout, memory: Vec::new(), limit: u64::MAX, ran: None }
    }

    /// Records the span of each executed statement from now on.
    pub fn watch(&mut self) {
        self.ran = Some(BTreeSet::new());
    }

    /// Returns the spans of the statements executed since [`Interpreter::watch`].
    pub fn ran(&mut self) -> BTreeSet<Span> {
        self.ran.take().unwrap_or_default()
    }

    /// Lets each call execute no more than this many statements (random programs may count to 2^64).
    pub fn limit(&mut self, statements: u64) {
        self.limit = statements;
    }

    /// Calls a function with one list of words for each parameter, including `self`. Those of mode `RefMut` are
    /// updated in place, also if a fault ends the call: then they have the values written before the fault. Returns
    /// the function's result as words.
    pub fn call(
        &mut self,
        function: FunctionId,
        arguments: &mut [Vec<u64>],
    ) -> Result<Vec<u64>, Stop> {
        let Some(definition) = self.module.functions.get(function.index()) else {
            return Err(Stop::Function(function));
        };
        let parameters = definition.parameters();
        if parameters.len() != arguments.len() {
            return Err(Stop::Arguments { expected: parameters.len(), found: arguments.len() });
        }
        for (index, (local, words)) in parameters.iter().zip(&*arguments).enumerate() {
            words_fit(self.module, &local.ty, words)
                .map_err(|problem| Stop::Argument { index, problem })?;
        }
        let given: Vec<&[u64]> = arguments.iter().map(Vec::as_slice).collect();
        let mut run = run::Run::new(self.module, &self.layout, &mut self.memory, self.limit);
        run.ran = self.ran.as_mut();
        let (outcome, addresses) = run.enter(function, &given);
        for ((local, words), address) in parameters.iter().zip(arguments).zip(addresses) {
            if local.mode == Mode::RefMut {
                let lent = &self.memory[address..address + words.len()];
                words.copy_from_slice(lent);
            }
        }
        outcome
    }
}
