//! The most instructions of any call, counted on an emulated processor: the longest paths must not be shorter.
//!
//! Calls follow one another in lives, each from the initial state of its component. Nothing of a call's results is kept, so
//! millions of calls are possible. Where subnormal numbers take longer, a second program tells which calls met one.
//!
//! It must not know where the lives come from.

use std::path::PathBuf;

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_ir::{FunctionId, Module};
use bessemer_legs::longest::{self, Numbers};
use bessemer_legs::toolchain::Toolchain;
use bessemer_legs::{harness, process, watch};

use super::lives::laid_out;
use super::search::Life;
use crate::error::Error;

/// The longest call of a life.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LongestCall {
    /// Its instructions, without those of the caller.
    pub instructions: u64,
    /// Its place among the calls.
    pub at: usize,
}

/// The longest call of a life, and the longest one with normal numbers alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Both {
    /// With any numbers.
    pub any: LongestCall,
    /// With normal ones; of no instructions if no call has them.
    pub normal: LongestCall,
}

impl Both {
    /// Returns the one with these numbers.
    pub fn of(&self, numbers: Numbers) -> LongestCall {
        match numbers {
            Numbers::Any => self.any,
            Numbers::Normal => self.normal,
        }
    }
}

/// A program that counts.
pub struct Counter {
    folder: process::Folder,
    toolchain: Toolchain,
    program: PathBuf,
    /// The program that tells which calls met a subnormal number; none where that makes no difference.
    notes: Option<(process::Folder, PathBuf)>,
    /// Number of calls so far.
    pub calls: usize,
    /// Instructions of each function's caller, which are counted with it.
    callers: Vec<u64>,
    /// The most instructions of a call of each function, without its caller.
    pub most: Vec<Both>,
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
        let program = watch::built(toolchain, folder.path(), &main, folder.sources(), &[]);
        let program = program.map_err(failed)?;
        let callers = longest::callers(toolchain, &main, functions.len()).map_err(failed)?;
        let notes = longest::has_slow_numbers(toolchain);
        let notes = notes.then(|| noting(compiled, options, functions, toolchain)).transpose()?;
        Ok(Counter {
            folder,
            toolchain: toolchain.clone(),
            program,
            notes,
            calls: 0,
            callers,
            most: vec![Both::default(); functions.len()],
        })
    }

    /// Runs a program on some input; returns a count for each call.
    fn run(
        &self,
        folder: &process::Folder,
        program: &std::path::Path,
        input: &[u8],
        calls: usize,
    ) -> Result<Vec<u64>, Error> {
        let failed = |said: String| {
            let said = said.replace(&folder.path().display().to_string(), ".");
            Error::Uncounted { name: self.toolchain.name(), said }
        };
        let own = folder.path().join(watch::FOLDER);
        let watched = watch::counted(&self.toolchain, &own, program, input);
        let counts = watched.map_err(failed)?.counts;
        if counts.len() != calls {
            return Err(failed(format!("{} of {calls} calls were counted", counts.len())));
        }
        Ok(counts)
    }

    /// Counts the calls of some lives. Returns the longest calls of each.
    ///
    /// # Errors
    /// The message of the emulator or the system.
    pub fn count(&mut self, lives: &[Life]) -> Result<Vec<Both>, Error> {
        let input: Vec<u8> = lives.iter().flat_map(Life::bytes).collect();
        let calls: usize = lives.iter().map(|it| it.calls.len()).sum();
        let noted = || match &self.notes {
            Some((folder, program)) => self.run(folder, program, &input, calls),
            None => Ok(vec![0; calls]),
        };
        let (counts, met) = std::thread::scope(|scope| {
            let noted = scope.spawn(noted);
            let counts = self.run(&self.folder, &self.program, &input, calls);
            (counts, noted.join())
        });
        let (counts, met) = (counts?, met.unwrap_or_else(|it| std::panic::resume_unwind(it))?);
        self.calls += calls;
        let mut rest = counts.iter().zip(&met);
        let longest = lives.iter().map(|life| {
            let caller = self.callers[life.target];
            let mut both = Both::default();
            for (at, (count, met)) in rest.by_ref().take(life.calls.len()).enumerate() {
                let call = LongestCall { instructions: count.saturating_sub(caller), at };
                let longer = |one: LongestCall| {
                    if call.instructions > one.instructions { call } else { one }
                };
                both.any = longer(both.any);
                if *met < harness::LINGERS {
                    both.normal = longer(both.normal);
                }
            }
            let most = &mut self.most[life.target];
            let longer = |one: LongestCall, other: LongestCall| {
                if other.instructions > one.instructions { other } else { one }
            };
            (most.any, most.normal) =
                (longer(most.any, both.any), longer(most.normal, both.normal));
            both
        });
        Ok(longest.collect())
    }
}

/// Builds the program that tells which calls met a subnormal number.
fn noting(
    compiled: &Compiled,
    options: &Options,
    functions: &[FunctionId],
    toolchain: &Toolchain,
) -> Result<(process::Folder, PathBuf), Error> {
    let failed = |said: String| Error::Compiler { name: toolchain.name(), said };
    let text = |module: &Module, taken: &[(FunctionId, u32)]| {
        harness::noted(module, taken, options, toolchain.bare)
    };
    let (folder, main) = laid_out(compiled, functions, text)?;
    let own = folder.path().join("subnormal_notes.c");
    std::fs::write(&own, harness::SUBNORMAL)
        .map_err(|source| Error::File { path: own.clone(), source })?;
    let sources = [folder.sources(), &[own]].concat();
    let flags: Vec<String> = longest::slow().map(|it| format!("-Wl,--wrap={it}")).collect();
    let flags: Vec<&str> = flags.iter().map(String::as_str).collect();
    let program =
        watch::built(toolchain, folder.path(), &main, &sources, &flags).map_err(failed)?;
    Ok((folder, program))
}
