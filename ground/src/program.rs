//! The onboard software as a program: the emitted C around its sockets, compiled once and started as a process
//! of its own.
//!
//! Knows compilers and processes, not what the software does. The key goes to its standard input: arguments
//! and the environment can be read by others.

use crate::key::Key;
use bessemer_legs::toolchain::{ARM, GCC, Toolchain};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::SystemTime;

/// Where the software runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Target {
    /// This machine.
    #[default]
    Native,
    /// An emulated Cortex-A9.
    A9,
}

/// Why it does not run.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The compiler refused, or is not there.
    #[error(
        "the onboard software does not compile:\n{0}\n`cargo xtask doctor` tells which tools are missing"
    )]
    Compile(String),
    /// A file cannot be read or written.
    #[error("`{path}`: {source}")]
    File {
        /// The file.
        path: PathBuf,
        /// An error of the system.
        source: std::io::Error,
    },
    /// The program does not start.
    #[error(
        "`{program}` does not start: {source}; `cargo xtask doctor` tells which tools are missing"
    )]
    Start {
        /// The program.
        program: String,
        /// An error of the system.
        source: std::io::Error,
    },
}

/// The compiled program.
#[derive(Clone, Debug)]
pub struct Program {
    path: PathBuf,
    toolchain: Toolchain,
}

impl Program {
    /// Compiles `generated/` and the program around it below the workspace's `root`, unless that has been done since
    /// they changed.
    ///
    /// # Errors
    /// An error of the compiler or of the system.
    pub fn build(root: &Path, target: Target) -> Result<Self, Error> {
        let (toolchain, name) = match target {
            Target::Native => (GCC, "onboard"),
            Target::A9 => (ARM, "onboard-a9"),
        };
        let (generated, own) = (root.join("generated"), root.join("ground/onboard"));
        let folder = root.join("target/fly");
        let file = |path: &Path, source| Error::File { path: path.to_owned(), source };
        std::fs::create_dir_all(&folder).map_err(|source| file(&folder, source))?;
        // One at a time: who comes second finds it done.
        let lock = folder.join(format!("{name}.lock"));
        let locked = std::fs::File::create(&lock).and_then(|it| it.lock().map(|()| it));
        let _locked = locked.map_err(|source| file(&lock, source))?;
        let program = Self { path: folder.join(name), toolchain };
        let sources = [files(&generated)?, files(&own)?].concat();
        if is_newer(&program.path, &sources) {
            return Ok(program);
        }
        let units: Vec<PathBuf> = sources
            .into_iter()
            .filter(|path| path.extension().is_some_and(|it| it == "c"))
            .collect();
        // A run may end in the middle: the program appears whole.
        let fresh = folder.join(format!("{name}.new"));
        let include = |folder: &Path| format!("-I{}", folder.display());
        let flags = [include(&generated), include(&own)];
        let flags: Vec<&str> = flags.iter().map(String::as_str).collect();
        program.toolchain.link(&units, &fresh, &flags).map_err(Error::Compile)?;
        std::fs::rename(&fresh, &program.path).map_err(|source| file(&fresh, source))?;
        Ok(program)
    }

    /// Starts it: the bus that it is to reach, the key.
    ///
    /// # Errors
    /// It does not start.
    pub fn start(&self, bus: u16, key: Option<&Key>) -> Result<Running, Error> {
        let mut command: Command = self.toolchain.runner(&self.path);
        command.arg(bus.to_string()).stdin(Stdio::piped());
        let failed = |source| Error::Start { program: self.path.display().to_string(), source };
        let mut child = command.spawn().map_err(failed)?;
        let line = key.map(Key::line).unwrap_or_default();
        let mut input = child.stdin.take();
        let told = input.as_mut().map_or(Ok(()), |input| writeln!(input, "{line}"));
        let running = Running { child, _input: input };
        told.map_err(failed)?;
        Ok(running)
    }
}

/// The running program: it ends when this is dropped.
#[derive(Debug)]
pub struct Running {
    child: Child,
    _input: Option<std::process::ChildStdin>,
}

impl Running {
    /// Whether it still runs.
    pub fn is_alive(&mut self) -> bool {
        matches!(self.child.try_wait(), Ok(None))
    }

    /// Its number, for whoever wants to kill it.
    pub fn id(&self) -> u32 {
        self.child.id()
    }

    /// Kills it.
    pub fn kill(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.kill();
    }
}

/// The C in a folder, in the order of the names.
fn files(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let failed = |source| Error::File { path: folder.to_owned(), source };
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.extension().is_some_and(|it| it == "c" || it == "h") {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

/// Whether a program was made after its sources were written.
fn is_newer(program: &Path, sources: &[PathBuf]) -> bool {
    let written = |path: &Path| path.metadata().and_then(|it| it.modified()).ok();
    let Some(made) = written(program) else { return false };
    let newest: Option<SystemTime> = sources.iter().filter_map(|path| written(path)).max();
    newest.is_some_and(|newest| newest < made)
}
