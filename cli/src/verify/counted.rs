//! The most instructions of any call, counted on an emulated processor: the longest paths must not be shorter.
//!
//! Calls follow one another in lives, from the initial state of their component or from one that the program keeps. Nothing of
//! a call's results is kept, so millions of calls are possible. Where subnormal numbers take longer, a second program says
//! which calls met one: those that are long enough to matter.
//!
//! It must not know where the lives come from.

use std::path::{Path, PathBuf};
use std::rc::Rc;

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_ir::{FunctionId, Module};
use bessemer_legs::longest::{self, Numbers};
use bessemer_legs::running::Running;
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
    /// With normal ones; of no instructions if no call has them, or none was looked at.
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

    fn of_mut(&mut self, numbers: Numbers) -> &mut LongestCall {
        match numbers {
            Numbers::Any => &mut self.any,
            Numbers::Normal => &mut self.normal,
        }
    }
}

/// A program, with the folder of its sources.
struct Program {
    toolchain: Toolchain,
    running: Running,
    /// The calls before the state that it keeps.
    kept: Option<Rc<[Life]>>,
    folder: process::Folder,
}

/// Programs that count.
pub struct Counter {
    program: Program,
    /// The program that tells which calls met a subnormal number; none where that makes no difference.
    notes: Option<Program>,
    /// Number of calls so far.
    pub calls: usize,
    /// Instructions of each function's caller, which are counted with it.
    callers: Vec<u64>,
    /// The most instructions of a call of each function, without its caller.
    pub most: Vec<Both>,
}

/// Lives of one component behind one another. The last one is of interest.
pub type Row = Vec<Life>;

impl Counter {
    /// Builds the programs for these functions, and starts them.
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
        let callers = longest::callers(toolchain, &main, functions.len()).map_err(failed)?;
        let program = Program::start(toolchain, folder, &main, &[], &[])?;
        let notes = longest::has_slow_numbers(toolchain);
        let notes = notes.then(|| noting(compiled, options, functions, toolchain)).transpose()?;
        let most = vec![Both::default(); functions.len()];
        Ok(Counter { program, notes, calls: 0, callers, most })
    }

    /// Counts the calls of some rows, each from the initial state. Returns the longest calls of the last life of each.
    ///
    /// A call with normal numbers is looked for only if it is longer than three quarters of the longest one so far.
    ///
    /// # Errors
    /// The message of the emulator or the system.
    pub fn count(&mut self, rows: &[Row]) -> Result<Vec<Both>, Error> {
        let floors: Vec<u64> = self.most.iter().map(|it| it.normal.instructions * 3 / 4).collect();
        self.count_from(None, rows, &floors)
    }

    /// Counts the calls of some lives, each from the state that other lives of the same component leave. Returns the longest
    /// calls of each; those with normal numbers are known where a call is longer than `floor`.
    ///
    /// # Errors
    /// The message of the emulator or the system.
    pub fn count_after(
        &mut self,
        before: &Rc<[Life]>,
        lives: &[Life],
        floor: u64,
    ) -> Result<Vec<Both>, Error> {
        let rows: Vec<Row> = lives.iter().map(|it| vec![it.clone()]).collect();
        let floors = vec![floor; self.most.len()];
        self.count_from(
            Some(before).filter(|it| it.iter().any(|life| !life.calls.is_empty())),
            &rows,
            &floors,
        )
    }

    /// Counts the calls of some rows, each from a kept state or the initial one.
    fn count_from(
        &mut self,
        before: Option<&Rc<[Life]>>,
        rows: &[Row],
        floors: &[u64],
    ) -> Result<Vec<Both>, Error> {
        let all: Vec<&Row> = rows.iter().collect();
        let counts = self.program.count(before, &all)?;
        self.calls += counts.iter().map(Vec::len).sum::<usize>();
        let mut found = Vec::new();
        for (row, counts) in rows.iter().zip(&counts) {
            let any = self.longest(row, counts, Numbers::Any);
            found.push(Both { any, normal: LongestCall::default() });
        }
        let Some(notes) = &mut self.notes else {
            self.most.iter_mut().for_each(|it| it.normal = it.any);
            return Ok(found.into_iter().map(|it| Both { normal: it.any, ..it }).collect());
        };
        let is_high = |at: &usize| {
            rows[*at].last().is_some_and(|it| found[*at].any.instructions > floors[it.target])
        };
        let chosen: Vec<usize> = (0..rows.len()).filter(is_high).collect();
        if chosen.is_empty() {
            return Ok(found);
        }
        let noted: Vec<&Row> = chosen.iter().map(|at| &rows[*at]).collect();
        let met = notes.count(before, &noted)?;
        for (at, met) in chosen.into_iter().zip(met) {
            let normal = counts[at].iter().zip(met);
            let normal = normal.map(|(count, met)| if met < harness::LINGERS { *count } else { 0 });
            found[at].normal = self.longest(&rows[at], &Vec::from_iter(normal), Numbers::Normal);
        }
        Ok(found)
    }

    /// Enters the calls of a row with these numbers. Returns the longest one of its last life.
    fn longest(&mut self, row: &[Life], counts: &[u64], numbers: Numbers) -> LongestCall {
        let mut counts = counts.iter();
        let mut last = LongestCall::default();
        for life in row {
            let caller = self.callers[life.target];
            let own = counts.by_ref().take(life.calls.len()).enumerate();
            last = own.fold(LongestCall::default(), |longest, (at, count)| {
                longest.longer(LongestCall { instructions: count.saturating_sub(caller), at })
            });
            let most = self.most[life.target].of_mut(numbers);
            *most = most.longer(last);
        }
        last
    }
}

impl Program {
    /// Builds a program of a folder with more sources and flags, and starts it.
    fn start(
        toolchain: &Toolchain,
        folder: process::Folder,
        main: &Path,
        more: &[PathBuf],
        flags: &[&str],
    ) -> Result<Program, Error> {
        let failed = |said: String| Error::Compiler { name: toolchain.name(), said };
        let sources = [folder.sources(), more].concat();
        let program = watch::built(toolchain, folder.path(), main, &sources, flags);
        let program = program.map_err(failed)?;
        let own = folder.path().join(watch::FOLDER);
        let running = Running::start(toolchain, &own, &program).map_err(failed)?;
        Ok(Program { toolchain: toolchain.clone(), running, kept: None, folder })
    }

    /// Returns the counts of the calls of each row.
    fn count(
        &mut self,
        before: Option<&Rc<[Life]>>,
        rows: &[&Row],
    ) -> Result<Vec<Vec<u64>>, Error> {
        let mut calls = rows.iter().flat_map(|row| *row).map(|it| it.calls.len()).sum::<usize>();
        let mut input = Vec::new();
        let mut first = harness::RESTARTS;
        let mut skipped = 0;
        if let Some(before) = before {
            first = harness::RETURNS;
            if !self.kept.as_ref().is_some_and(|it| Rc::ptr_eq(it, before)) {
                write_row(before, harness::RESTARTS, &mut input);
                skipped = before.iter().map(|it| it.calls.len()).sum();
                calls += skipped;
                first = harness::KEEPS;
            }
        }
        for row in rows {
            if write_row(row, first, &mut input) && before.is_some() {
                first = harness::RETURNS;
                self.kept = before.cloned();
            }
        }
        let counts = self.running.count(input, calls).map_err(|said| Error::Uncounted {
            name: self.toolchain.name(),
            said: said.replace(&self.folder.path().display().to_string(), "."),
        })?;
        let mut rest = counts.into_iter().skip(skipped);
        let of = |row: &&Row| {
            let calls = row.iter().map(|it| it.calls.len()).sum();
            rest.by_ref().take(calls).collect()
        };
        Ok(rows.iter().map(of).collect())
    }
}

/// Writes the calls of a row, the first with a flag. Returns true if there is one.
fn write_row(row: &[Life], first: u64, input: &mut Vec<u8>) -> bool {
    let mut flag = first;
    for life in row.iter().filter(|it| !it.calls.is_empty()) {
        input.extend(life.bytes_with(flag));
        flag = harness::GOES_ON;
    }
    flag != first
}

/// Builds the program that tells which calls met a subnormal number.
fn noting(
    compiled: &Compiled,
    options: &Options,
    functions: &[FunctionId],
    toolchain: &Toolchain,
) -> Result<Program, Error> {
    let text = |module: &Module, taken: &[(FunctionId, u32)]| {
        harness::noted(module, taken, options, toolchain.bare)
    };
    let (folder, main) = laid_out(compiled, functions, text)?;
    let own = folder.path().join("subnormal_notes.c");
    std::fs::write(&own, harness::SUBNORMAL)
        .map_err(|source| Error::File { path: own.clone(), source })?;
    let flags: Vec<String> = longest::slow().map(|it| format!("-Wl,--wrap={it}")).collect();
    let flags: Vec<&str> = flags.iter().map(String::as_str).collect();
    Program::start(toolchain, folder, &main, &[own], &flags)
}
