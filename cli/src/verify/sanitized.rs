//! Calls of the C as a compiler's sanitizers watch it: addresses and undefined behaviour.
//!
//! It must not know where the calls come from.

use std::io::{Seek as _, Write as _};
use std::process::Stdio;

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_ir::{FunctionId, Module};
use bessemer_legs::toolchain::{CLANG, GCC, Toolchain};
use bessemer_legs::{harness, process};

use super::lives::laid_out;
use super::search::Life;
use crate::error::Error;

/// Flags of gcc and clang: the first report ends the program.
const FLAGS: [&str; 3] = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-w"];

/// Returns the compilers that have sanitizers. Clang's libraries for them are a package of their own.
pub fn compilers() -> Vec<Toolchain> {
    let list = [GCC, CLANG].map(|it| Toolchain { level: 1, ..it });
    list.into_iter().filter(|it| bessemer_tools::check(&[it.compiler]).is_ok()).collect()
}

/// The C as a program with sanitizers.
pub struct Program {
    folder: process::Folder,
    toolchain: Toolchain,
    path: std::path::PathBuf,
    /// Number of calls so far.
    pub calls: usize,
}

impl Program {
    /// Builds the program for these functions.
    ///
    /// # Errors
    /// The message of the compiler or the system.
    pub fn build(
        compiled: &Compiled,
        options: &Options,
        functions: &[FunctionId],
        toolchain: &Toolchain,
    ) -> Result<Program, Error> {
        let failed = |said: String| Error::Compiler { name: toolchain.name(), said };
        let text =
            |module: &Module, taken: &[(FunctionId, u32)]| harness::lives(module, taken, options);
        let (folder, main) = laid_out(compiled, functions, text)?;
        let path = folder.path().join("sanitized");
        let include = format!("-I{}", folder.path().display());
        let flags: Vec<&str> = FLAGS.into_iter().chain([include.as_str()]).collect();
        toolchain.around(&main, folder.sources(), &path, &flags).map_err(failed)?;
        Ok(Program { folder, toolchain: toolchain.clone(), path, calls: 0 })
    }

    /// Runs lives. Returns the report of a sanitizer, without the folder of the C; none if there is none.
    ///
    /// # Errors
    /// The message of the system.
    pub fn run(&mut self, lives: &[Life]) -> Result<Option<String>, Error> {
        let here = self.folder.path();
        let failed = |source| Error::File { path: here.to_owned(), source };
        let mut input = tempfile::tempfile().map_err(failed)?;
        for life in lives {
            input.write_all(&life.bytes()).map_err(failed)?;
            self.calls += life.calls.len();
        }
        input.rewind().map_err(failed)?;
        let mut command = self.toolchain.runner(&self.path);
        command.stdin(Stdio::from(input)).stdout(Stdio::null());
        let output = command.output().map_err(failed)?;
        if output.status.success() {
            return Ok(None);
        }
        let said = String::from_utf8_lossy(&output.stderr);
        let report = said.lines().find(|line| line.contains("rror: "));
        let report = report.map_or_else(|| output.status.to_string(), str::to_owned);
        Ok(Some(report.replace(&format!("{}/", here.display()), "")))
    }
}
