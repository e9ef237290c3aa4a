//! The onboard software as a program. The emitted C is compiled with its sockets and started as a process, or runs as
//! firmware of an emulated machine, for which a [`Relay`] opens sockets.
//!
//! Knows compilers and processes, not what the software does. The key goes to its standard input: arguments
//! and the environment can be read by others.

use crate::key::Key;
use crate::relay::Relay;
use bessemer_backend::c::CFile;
use bessemer_legs::firmware::{Firmware, Machine};
use bessemer_legs::toolchain::{ARM, GCC, Missing, Toolchain, ZYNQ};
use sim::Aircraft;
use std::io::Write;
use std::net::{Ipv4Addr, SocketAddrV4};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;
use std::time::{Duration, SystemTime};

/// Timeout of the board's serial line, emulated on a busy machine.
const ANSWER_TIMEOUT: Duration = Duration::from_secs(30);

/// Target that runs the software.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Target {
    /// This machine.
    #[default]
    Native,
    /// An emulated Cortex-A9, under Linux.
    A9,
    /// An emulated Zynq without an operating system.
    Zynq,
}

/// Reason why the onboard software does not run.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// A compiler or an emulator is missing.
    #[error("{0}: {install}", install = .0.install)]
    Missing(#[from] Missing),
    /// The compiler reported an error.
    #[error("the onboard software does not compile:\n{0}")]
    Compile(String),
    /// A file cannot be read or written.
    #[error("`{path}`: {source}")]
    File {
        /// The file.
        path: PathBuf,
        /// An error of the system.
        source: std::io::Error,
    },
    /// The program could not be started.
    #[error("`{program}` does not start: {source}")]
    Start {
        /// The program.
        program: String,
        /// An error of the system.
        source: std::io::Error,
    },
}

/// Arguments with which the program starts.
#[derive(Clone, Copy, Debug)]
pub struct Boot<'a> {
    /// Port of the bus, on this machine.
    pub bus: u16,
    /// Key of those who may command.
    pub key: Option<&'a Key>,
    /// Aircraft to fly.
    pub aircraft: Aircraft,
    /// Address at which the program receives commands; port 0 for any free port.
    pub link: SocketAddrV4,
}

impl Boot<'_> {
    /// Returns the arguments for a bus alone: the Mambo, without a key, on loopback.
    pub fn on(bus: u16) -> Self {
        let link = SocketAddrV4::new(Ipv4Addr::LOCALHOST, 0);
        Self { bus, key: None, aircraft: Aircraft::Mambo, link }
    }
}

/// The compiled program.
#[derive(Clone, Debug)]
pub enum Program {
    /// A program with sockets.
    Process {
        /// The program.
        path: PathBuf,
        /// Toolchain of the target.
        toolchain: Toolchain,
    },
    /// Firmware at the other end of a serial line.
    Firmware(Arc<Firmware>),
}

impl Program {
    /// Compiles `generated/` and the program around it below the workspace's `root`, unless that has been done since
    /// they changed.
    ///
    /// # Errors
    /// A tool is missing; an error of the compiler or of the system.
    pub fn build(root: &Path, target: Target) -> Result<Self, Error> {
        let (toolchain, name) = match target {
            Target::Native => (GCC, "onboard"),
            Target::A9 => (ARM, "onboard-a9"),
            Target::Zynq => return firmware(root),
        };
        toolchain.check()?;
        let folders = ["generated", "ground/onboard", "ground/onboard/unix"];
        let folders = folders.map(|folder| root.join(folder));
        let folder = root.join("target/fly");
        let file = |path: &Path, source| Error::File { path: path.to_owned(), source };
        std::fs::create_dir_all(&folder).map_err(|source| file(&folder, source))?;
        // One at a time: who comes second finds it done.
        let lock = folder.join(format!("{name}.lock"));
        let locked = std::fs::File::create(&lock).and_then(|it| it.lock().map(|()| it));
        let _locked = locked.map_err(|source| file(&lock, source))?;
        let path = folder.join(name);
        let mut sources = Vec::new();
        for folder in &folders {
            sources.extend(files(folder)?);
        }
        if is_newer(&path, &sources) {
            return Ok(Self::Process { path, toolchain });
        }
        let units: Vec<PathBuf> = sources
            .into_iter()
            .filter(|path| path.extension().is_some_and(|it| it == "c"))
            .collect();
        // A run may end in the middle: the program appears whole.
        let fresh = folder.join(format!("{name}.new"));
        let flags = folders.map(|folder| format!("-I{}", folder.display()));
        let flags: Vec<&str> = flags.iter().map(String::as_str).collect();
        toolchain.link(&units, &fresh, &flags).map_err(Error::Compile)?;
        std::fs::rename(&fresh, &path).map_err(|source| file(&fresh, source))?;
        Ok(Self::Process { path, toolchain })
    }

    /// Starts the program.
    ///
    /// # Errors
    ///
    /// It does not start.
    pub fn start(&self, boot: &Boot<'_>) -> Result<Running, Error> {
        match self {
            Self::Process { path, toolchain } => {
                let mut command: Command = toolchain.runner(path);
                let link = boot.link.to_string();
                command.args(["-a", boot.aircraft.name(), "-l", &link, &boot.bus.to_string()]);
                command.stdin(Stdio::piped());
                // Ctrl-C at a terminal reaches the parent alone, which then ends the software.
                #[cfg(unix)]
                std::os::unix::process::CommandExt::process_group(&mut command, 0);
                let failed = |source| Error::Start { program: path.display().to_string(), source };
                let mut child = command.spawn().map_err(failed)?;
                let line = boot.key.map(Key::line).unwrap_or_default();
                let mut input = child.stdin.take();
                let told = input.as_mut().map_or(Ok(()), |input| writeln!(input, "{line}"));
                let running = Running { process: child.into(), relay: None, _input: input };
                told.map_err(failed)?;
                Ok(running)
            }
            Self::Firmware(firmware) => {
                let failed = |why: std::io::Error| Error::Start {
                    program: "the emulated Zynq".to_owned(),
                    source: why,
                };
                let started = firmware.start(ANSWER_TIMEOUT);
                let (process, line) =
                    started.map_err(|error| failed(std::io::Error::other(error)))?;
                let relay = Relay::start(line, boot).map_err(failed)?;
                Ok(Running { process, relay: Some(relay), _input: None })
            }
        }
    }
}

/// The firmware of the Zynq. Objects that were compiled before are reused (`bessemer_legs`).
fn firmware(root: &Path) -> Result<Program, Error> {
    ZYNQ.check()?;
    let mut emitted = Vec::new();
    for path in files(&root.join("generated"))? {
        let text = std::fs::read_to_string(&path)
            .map_err(|source| Error::File { path: path.clone(), source })?;
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        emitted.push(CFile { name, text, map: Vec::new() });
    }
    let board = ["legs/c/link", "examples/zynq/board", "ground/onboard", "ground/onboard/zynq"];
    let board = board.map(|folder| root.join(folder));
    let built = Firmware::build(&board, &[], &emitted, &ZYNQ);
    let built = built.map_err(|error| Error::Compile(error.to_string()))?;
    Ok(Program::Firmware(Arc::new(built)))
}

/// The running program; dropping it ends the program.
#[derive(Debug)]
pub struct Running {
    process: Machine,
    relay: Option<Relay>,
    _input: Option<std::process::ChildStdin>,
}

impl Running {
    /// Returns the reason why the program no longer works; `None` while it runs.
    pub fn ended(&mut self) -> Option<String> {
        let wrong = self.relay.as_ref().and_then(Relay::wrong);
        // A process that is gone closes its line: the process is the reason.
        let gone = self.process.ended().map(|how| format!("its process ended: {how}"));
        gone.or_else(|| wrong.map(ToString::to_string))
    }

    /// Returns the process number, for tests that kill it.
    pub fn id(&self) -> u32 {
        self.process.id()
    }

    /// Kills it.
    pub fn kill(&mut self) {
        self.process.kill();
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

/// Returns true if a program is newer than its sources.
fn is_newer(program: &Path, sources: &[PathBuf]) -> bool {
    let written = |path: &Path| path.metadata().and_then(|it| it.modified()).ok();
    let Some(made) = written(program) else { return false };
    let newest: Option<SystemTime> = sources.iter().filter_map(|path| written(path)).max();
    newest.is_some_and(|newest| newest < made)
}
