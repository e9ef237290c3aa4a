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

impl LongestCall {
    /// Returns the longer one; this one if they are equal.
    fn longer(self, other: LongestCall) -> LongestCall {
        if other.instructions > self.instructions { other } else { self }
    }
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
        let parts: Vec<_> = lives.iter().map(|it| (harness::RESTARTS, it)).collect();
        self.count_parts(&parts)
    }

    /// Counts the calls of some lives, each from the state that other lives of the same component leave, one behind the
    /// other. The others are counted once.
    ///
    /// # Errors
    /// The message of the emulator or the system.
    pub fn count_after(&mut self, before: &[Life], lives: &[Life]) -> Result<Vec<Both>, Error> {
        if before.is_empty() {
            return self.count(lives);
        }
        let mut parts = in_a_row(before);
        let mut flag = harness::KEEPS;
        for life in lives {
            parts.push((flag, life));
            if !life.calls.is_empty() {
                flag = harness::RETURNS;
            }
        }
        let mut found = self.count_parts(&parts)?;
        Ok(found.split_off(before.len()))
    }

    /// Counts the calls of lives that follow one another. Returns the longest calls of the last life of each row.
    ///
    /// # Errors
    /// The message of the emulator or the system.
    pub fn count_rows(&mut self, rows: &[Vec<Life>]) -> Result<Vec<Both>, Error> {
        let parts: Vec<_> = rows.iter().flat_map(|it| in_a_row(it)).collect();
        let found = self.count_parts(&parts)?;
        let mut end = 0;
        let ends = rows.iter().map(|it| {
            end += it.len();
            end.checked_sub(1).and_then(|last| found.get(last)).copied().unwrap_or_default()
        });
        Ok(ends.collect())
    }

    /// Counts the calls of lives in one run, each with the flag of its first call.
    fn count_parts(&mut self, parts: &[(u64, &Life)]) -> Result<Vec<Both>, Error> {
        let input: Vec<u8> = parts.iter().flat_map(|(flag, it)| it.bytes_with(*flag)).collect();
        let calls = parts.iter().map(|it| it.1.calls.len()).sum::<usize>();
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
        let longest = parts.iter().map(|(_, life)| {
            let caller = self.callers[life.target];
            let mut both = Both::default();
            for (at, (count, met)) in rest.by_ref().take(life.calls.len()).enumerate() {
                let call = LongestCall { instructions: count.saturating_sub(caller), at };
                both.any = both.any.longer(call);
                if *met < harness::LINGERS {
                    both.normal = both.normal.longer(call);
                }
            }
            let most = &mut self.most[life.target];
            (most.any, most.normal) = (most.any.longer(both.any), most.normal.longer(both.normal));
            both
        });
        Ok(longest.collect())
    }
}

/// Returns lives with their flags, of which the first begins in the initial state.
fn in_a_row(lives: &[Life]) -> Vec<(u64, &Life)> {
    let mut flag = harness::RESTARTS;
    let mut parts = Vec::new();
    for life in lives {
        parts.push((flag, life));
        if !life.calls.is_empty() {
            flag = harness::GOES_ON;
        }
    }
    parts
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
