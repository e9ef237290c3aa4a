//! Emitted C as a process: compiled in a temporary folder, and called through pipes.

use std::collections::{BTreeMap, BTreeSet};
use std::io::{BufReader, BufWriter, Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Stdio};

use bessemer_backend::c::CFile;
use bessemer_codegen::compile::Compiled;
use bessemer_ir::FunctionId;
use tempfile::TempDir;

use crate::harness;
use crate::toolchain::Toolchain;
use crate::units;

/// Reason why a leg could not run.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The compiler reported errors.
    #[error("{0}")]
    Compile(String),
    /// The process or its files failed.
    #[error("{0}")]
    Io(#[from] std::io::Error),
}

/// Emitted C in a temporary folder.
pub struct Folder {
    folder: TempDir,
    sources: Vec<PathBuf>,
}

/// A running entry point.
pub struct Process {
    child: Child,
    input: BufWriter<ChildStdin>,
    output: BufReader<ChildStdout>,
    results: usize,
    said: String,
    // Holds the program while it runs.
    folder: TempDir,
}

/// Writes the C of `compiled` to a folder.
///
/// # Errors
/// An error of the file system.
pub fn lay_out(compiled: &Compiled) -> Result<Folder, Error> {
    lay_out_files(&compiled.files)
}

fn lay_out_files<'f>(files: impl IntoIterator<Item = &'f CFile>) -> Result<Folder, Error> {
    let folder = tempfile::tempdir()?;
    let mut sources = Vec::new();
    for file in files {
        let path = folder.path().join(&file.name);
        std::fs::create_dir_all(path.parent().unwrap_or(folder.path()))?;
        std::fs::write(&path, &file.text)?;
        if file.name.ends_with(".c") {
            sources.push(path);
        }
    }
    Ok(Folder { folder, sources })
}

/// Writes only the C that a program needs, since writing hundreds of files takes longer than compiling.
///
/// # Errors
///
/// An error of the file system.
pub fn lay_out_needed(files: &[CFile], main: &str) -> Result<Folder, Error> {
    let needed = needed(files, main);
    lay_out_files(files.iter().filter(|file| stem(file).is_some_and(|it| needed.contains(it))))
}

/// Returns the name of a C file without its extension.
fn stem(file: &CFile) -> Option<&str> {
    match file.name.rsplit_once('.') {
        Some((stem, "c" | "h")) => Some(last(stem)),
        _ => None,
    }
}

impl Folder {
    /// Returns the path of the folder.
    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    /// Returns the C sources in the folder.
    pub fn sources(&self) -> &[PathBuf] {
        &self.sources
    }

    /// Returns the folder itself, to keep it.
    pub fn into_folder(self) -> TempDir {
        self.folder
    }
}

impl Process {
    /// Compiles the C of `compiled` with a program around `entry`, and starts it.
    ///
    /// # Errors
    /// An error of the compiler or of the system.
    pub fn start(
        compiled: &Compiled,
        entry: FunctionId,
        toolchain: &Toolchain,
    ) -> Result<Process, Error> {
        let params = compiled.module.functions[entry.index()].params;
        let main = harness::program(&compiled.explicit, entry, params);
        let mut process = Process::run(compiled, &main, toolchain, &[])?;
        let module = &compiled.explicit;
        let function = &module.functions[entry.index()];
        let state = match function.owner {
            Some(bessemer_ir::Owner::Struct(id)) => module.width(&bessemer_ir::Type::Struct(id)),
            _ => 0,
        };
        process.results = 1 + module.width(&function.result) + state;
        Ok(process)
    }

    /// Compiles the C of `compiled` with the text of a program around it, and starts it.
    ///
    /// # Errors
    /// An error of the compiler or of the system.
    pub fn run(
        compiled: &Compiled,
        main: &str,
        toolchain: &Toolchain,
        flags: &[&str],
    ) -> Result<Process, Error> {
        Process::run_files(&compiled.files, main, toolchain, flags)
    }

    /// Runs a program with the files that it includes, directly or not.
    ///
    /// # Errors
    /// An error of the compiler or of the system.
    pub fn run_files(
        files: &[CFile],
        main: &str,
        toolchain: &Toolchain,
        flags: &[&str],
    ) -> Result<Process, Error> {
        let Folder { folder, sources } = lay_out_needed(files, main)?;
        Process::of(folder, &sources, main, toolchain, flags)
    }

    /// Runs the program as [`run`](Process::run) does, with several files in a translation unit: see [`units`].
    ///
    /// # Errors
    /// An error of the compiler or of the system.
    pub fn run_in_units(
        compiled: &Compiled,
        main: &str,
        toolchain: &Toolchain,
        flags: &[&str],
    ) -> Result<Process, Error> {
        let Folder { folder, sources } = lay_out_needed(&compiled.files, main)?;
        let units = units::write(folder.path(), &sources)?;
        Process::of(folder, &units, main, toolchain, flags)
    }

    fn of(
        folder: TempDir,
        sources: &[PathBuf],
        main: &str,
        toolchain: &Toolchain,
        flags: &[&str],
    ) -> Result<Process, Error> {
        let path = folder.path().join("harness_main.c");
        std::fs::write(&path, main)?;
        let program = folder.path().join("harness");
        let said = toolchain.around(&path, sources, &program, flags).map_err(Error::Compile)?;
        let (child, input, output) = spawn(toolchain, &program)?;
        Ok(Process { child, input, output, results: 0, said, folder })
    }

    /// Returns the compiler's warnings, if flags kept them from being errors.
    pub fn said(&self) -> &str {
        &self.said
    }

    /// Restarts the program, with the component in its initial state.
    ///
    /// # Errors
    ///
    /// An error of the system.
    pub fn restart(&mut self, toolchain: &Toolchain) -> Result<(), Error> {
        self.child.kill()?;
        self.child.wait()?;
        let program = self.folder.path().join("harness");
        (self.child, self.input, self.output) = spawn(toolchain, &program)?;
        Ok(())
    }

    /// Calls the entry point with the arguments' words; returns status, result and state.
    ///
    /// # Errors
    ///
    /// The process died.
    pub fn step(&mut self, arguments: &[u64]) -> Result<Vec<u64>, Error> {
        self.send(arguments)?;
        self.receive(self.results)
    }

    /// Sends calls of one entry of [`harness::programs`](crate::harness::programs), by its index; the results are
    /// received in order. There may be at most [`at_once`] calls, or both processes could wait for each other.
    ///
    /// # Errors
    ///
    /// The process died.
    pub fn ask(&mut self, place: usize, calls: &[impl AsRef<[Vec<u64>]>]) -> Result<(), Error> {
        for call in calls {
            self.write(&[place as u64])?;
            call.as_ref().iter().try_for_each(|words| self.write(words))?;
        }
        self.send(&[HAND_OVER])
    }

    /// Writes words to the process.
    ///
    /// # Errors
    /// The process died.
    pub fn send(&mut self, words: &[u64]) -> Result<(), Error> {
        self.write(words)?;
        Ok(self.input.flush()?)
    }

    fn write(&mut self, words: &[u64]) -> Result<(), Error> {
        for word in words {
            self.input.write_all(&word.to_le_bytes())?;
        }
        Ok(())
    }

    /// Reads words from the process.
    ///
    /// # Errors
    /// The process died.
    pub fn receive(&mut self, count: usize) -> Result<Vec<u64>, Error> {
        let mut words = Vec::with_capacity(count);
        for _ in 0..count {
            let mut bytes = [0; 8];
            self.output.read_exact(&mut bytes)?;
            words.push(u64::from_le_bytes(bytes));
        }
        Ok(words)
    }
}

/// Returns the names, without extension, of the files that a program includes, directly or indirectly.
fn needed<'f>(files: &'f [CFile], main: &str) -> BTreeSet<&'f str> {
    let mut texts: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for file in files {
        if let Some(stem) = stem(file) {
            texts.entry(stem).or_default().push(&file.text);
        }
    }
    let mut needed = BTreeSet::new();
    let mut open = vec![main];
    while let Some(text) = open.pop() {
        let headers = text.lines().filter_map(|line| line.strip_prefix("#include \""));
        for header in headers.filter_map(|rest| rest.strip_suffix(".h\"")) {
            if let Some((stem, texts)) = texts.get_key_value(last(header))
                && needed.insert(*stem)
            {
                open.extend(texts);
            }
        }
    }
    needed
}

/// Returns a file's name without the folder of headers.
fn last(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

/// Index that makes the program flush its output instead of a call.
pub const HAND_OVER: u64 = u64::MAX;

/// Number of words that a pipe can hold before it is read: 32 KiB of Linux's 64.
const HELD: usize = 4096;

/// Returns the number of calls that can be sent before results are read, with at most `words` words in each
/// direction.
pub fn at_once(words: usize) -> usize {
    (HELD / words.max(1)).max(1)
}

type Running = (Child, BufWriter<ChildStdin>, BufReader<ChildStdout>);

fn spawn(toolchain: &Toolchain, program: &Path) -> Result<Running, Error> {
    let mut child =
        toolchain.runner(program).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn()?;
    match (child.stdin.take(), child.stdout.take()) {
        (Some(input), Some(output)) => Ok((child, BufWriter::new(input), BufReader::new(output))),
        _ => Err(Error::Compile("the process has no pipes".into())),
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
