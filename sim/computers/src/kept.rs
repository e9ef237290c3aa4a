//! Legs whose component this side keeps. A call has the words of the component and of the arguments. It returns the status and
//! the words of the result, of the component and of each changed argument.
//!
//! Invariant: the three raw legs take and return the same words, so that one [`Kept`] serves all.

use std::io::{Read, Write};

use bessemer_backend::c::Options;
use bessemer_backend::c::names::FAULTS;
use bessemer_codegen::compile;
use bessemer_interpret::{Interpreter, Stop};
use bessemer_ir::{Fault, FunctionId, Mode, Module};
use bessemer_legs::board::Board;
use bessemer_legs::harness;
use bessemer_legs::process::Process;
use bessemer_legs::toolchain::Toolchain;

use crate::error::Error;
use crate::leg::Leg;

/// Whoever runs a call. The answer is a fault, or words.
pub(crate) trait Raw {
    fn run(&mut self, words: &[u64]) -> Result<Result<Vec<u64>, Fault>, Error>;
}

/// An entry point that R runs, with the words of its component.
#[derive(Debug)]
pub struct Kept<R> {
    pub(crate) raw: R,
    pub(crate) name: String,
    /// Words of the component.
    pub(crate) state: Vec<u64>,
    /// Number of words of the arguments.
    pub(crate) taken: usize,
    /// Number of words of the result.
    pub(crate) returned: usize,
}

impl<R> Kept<R> {
    /// Returns the words of the component after the last call.
    pub fn state(&self) -> &[u64] {
        &self.state
    }
}

impl<R: Raw> Leg for Kept<R> {
    fn call(&mut self, arguments: &[u64]) -> Result<Vec<u64>, Error> {
        let (found, wanted) = (arguments.len(), self.taken);
        if found != wanted {
            return Err(Error::Words { name: self.name.clone(), found, wanted });
        }
        let answer = self.raw.run(&[&self.state, arguments].concat())?;
        let mut words = answer.map_err(|fault| Error::Fault { name: self.name.clone(), fault })?;
        let end = self.returned + self.state.len();
        if words.len() < end {
            return Err(Error::Result { found: words.len(), wanted: end });
        }
        self.state = words.drain(self.returned..end).collect();
        Ok(words)
    }
}

/// The interpreter of the IR.
pub struct Interpreted<'p> {
    interpreter: Interpreter<'p>,
    module: &'p Module,
    entry: FunctionId,
}

impl<'p> Interpreted<'p> {
    pub(crate) fn new(module: &'p Module, entry: FunctionId) -> Self {
        Self { interpreter: Interpreter::new(module), module, entry }
    }
}

impl Raw for Interpreted<'_> {
    fn run(&mut self, words: &[u64]) -> Result<Result<Vec<u64>, Fault>, Error> {
        let parameters = self.module.functions[self.entry.index()].parameters();
        let mut rest = words;
        let part = |rest: &mut &[u64], width| {
            let (part, behind) = rest.split_at_checked(width).unwrap_or((rest, &[]));
            *rest = behind;
            part.to_vec()
        };
        let mut arguments: Vec<Vec<u64>> =
            parameters.iter().map(|it| part(&mut rest, self.module.width(&it.ty))).collect();
        let mut words = match self.interpreter.call(self.entry, &mut arguments) {
            Ok(words) => words,
            Err(Stop::Fault { fault, .. }) => return Ok(Err(fault)),
            Err(stop) => {
                let name = self.module.functions[self.entry.index()].name.clone();
                return Err(Error::Stop { name, why: stop.to_string() });
            }
        };
        for (index, (parameter, argument)) in parameters.iter().zip(&arguments).enumerate() {
            if index == 0 || parameter.mode == Mode::RefMut {
                words.extend(argument);
            }
        }
        Ok(Ok(words))
    }
}

/// The emitted C in a process.
pub struct Compiled {
    process: Process,
    /// Number of words after a status without a fault.
    results: usize,
}

impl Compiled {
    pub(crate) fn start(
        compiled: &compile::Compiled,
        options: &Options,
        entry: (FunctionId, u32),
        toolchain: &Toolchain,
        results: usize,
    ) -> Result<Self, Error> {
        let main = harness::programs_with(&compiled.explicit, &[entry], options);
        Ok(Self { process: Process::run(compiled, &main, toolchain, &[])?, results })
    }
}

impl Raw for Compiled {
    fn run(&mut self, words: &[u64]) -> Result<Result<Vec<u64>, Fault>, Error> {
        self.process.ask(0, &[[words.to_vec()]])?;
        let status = self.process.receive(1)?.first().copied().unwrap_or_default();
        if status != 0 {
            return Ok(Err(fault(status)));
        }
        Ok(Ok(self.process.receive(self.results)?))
    }
}

/// The emitted C on a board at the end of a line L.
#[derive(Debug)]
pub struct Boarded<L> {
    board: Board<L>,
    /// Index of the entry point in the firmware.
    place: usize,
}

impl<L> Boarded<L> {
    pub(crate) fn new(board: Board<L>, place: usize) -> Self {
        Self { board, place }
    }
}

impl<L: Read + Write> Raw for Boarded<L> {
    fn run(&mut self, words: &[u64]) -> Result<Result<Vec<u64>, Fault>, Error> {
        let mut answer = self.board.call(self.place, words.iter().copied())?;
        Ok(match answer.first() {
            Some(0) => Ok(answer.split_off(1)),
            Some(status) => Err(fault(*status)),
            None => Err(Fault::LeftOut),
        })
    }
}

/// Returns the fault of a status of the C other than 0.
fn fault(status: u64) -> Fault {
    let index = usize::try_from(status).unwrap_or(usize::MAX).wrapping_sub(1);
    FAULTS.get(index).copied().unwrap_or(Fault::LeftOut)
}
