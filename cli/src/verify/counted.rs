//! The most instructions of any call, counted on an emulated processor: the longest paths must not be shorter.
//!
//! Calls follow one another in lives, each from the initial state of its component. Nothing of a call's results is kept, so
//! millions of calls are possible.
//!
//! It must not know where the lives come from.

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_ir::{FunctionId, Module};
use bessemer_legs::toolchain::Toolchain;
use bessemer_legs::{harness, longest, process, watch};

use super::lives::laid_out;
use super::search::Life;
use crate::error::Error;

/// A program that counts.
pub struct Counter {
    folder: process::Folder,
    toolchain: Toolchain,
    program: std::path::PathBuf,
    /// Number of calls so far.
    pub calls: usize,
    /// Instructions of each function's caller, which are counted with it.
    callers: Vec<u64>,
    /// The most instructions of a call of each function, without its caller.
    pub most: Vec<u64>,
}

impl Counter {
    /// Builds the program for these functions.
    ///
    /// # Errors
    /// The message of the compiler or the system.
    pub fn build(
        compiled: &Compiled,
        options: &Options,
        functions: &[FunctionId],
        toolchain: &Toolchain,
    ) -> Result<Counter, Error> {
        let failed = |said: String| Error::Compiler { name: toolchain.name(), said };
        let text = |module: &Module, taken: &[(FunctionId, u32)]| {
            harness::counted(module, taken, options, toolchain.bare)
        };
        let (folder, main) = laid_out(compiled, functions, text)?;
        let program = watch::built(toolchain, folder.path(), &main, folder.sources());
        let program = program.map_err(failed)?;
        let callers = longest::callers(toolchain, &main, functions.len()).map_err(failed)?;
        Ok(Counter {
            folder,
            toolchain: toolchain.clone(),
            program,
            calls: 0,
            callers,
            most: vec![0; functions.len()],
        })
    }

    /// Counts the calls of some lives. Returns the most instructions of a call of each.
    ///
    /// # Errors
    /// The message of the emulator or the system.
    pub fn count(&mut self, lives: &[Life]) -> Result<Vec<u64>, Error> {
        let input: Vec<u8> = lives.iter().flat_map(Life::bytes).collect();
        let failed = |said: String| {
            let said = said.replace(&self.folder.path().display().to_string(), ".");
            Error::Uncounted { name: self.toolchain.name(), said }
        };
        let own = self.folder.path().join(watch::FOLDER);
        let watched = watch::counted(&self.toolchain, &own, &self.program, &input);
        let counts = watched.map_err(failed)?.counts;
        let calls: usize = lives.iter().map(|it| it.calls.len()).sum();
        if counts.len() != calls {
            let said = format!("{} of {calls} calls were counted", counts.len());
            return Err(failed(said));
        }
        self.calls += calls;
        let mut rest = counts.as_slice();
        let most = lives.iter().map(|life| {
            let own = rest.split_off(..life.calls.len()).unwrap_or_default();
            let most = own.iter().copied().max().unwrap_or_default();
            let caller = self.callers[life.target];
            let most = most.saturating_sub(caller);
            self.most[life.target] = self.most[life.target].max(most);
            most
        });
        Ok(most.collect())
    }
}
