//! Emitted C as the firmware of a board, with the board's own startup code. An emulator runs it, and its serial line
//! is a socket of this process.
//!
//! What it must not know: any model, any board; a board is folders with C, startup code and a linker script.

use std::collections::BTreeSet;
use std::os::fd::OwnedFd;
use std::os::unix::net::UnixStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::time::Duration;

use bessemer_backend::c::CFile;
use tempfile::TempDir;

use crate::process::{Error, lay_out_needed};
use crate::toolchain::{Sizes, Toolchain};

/// Firmware that was built.
#[derive(Debug)]
pub struct Firmware {
    program: PathBuf,
    toolchain: Toolchain,
    // Holds the program.
    _folder: TempDir,
}

impl Firmware {
    /// Compiles the sources of a board's folders, generated sources, and the emitted files that these include. Links
    /// them by the folders' linker script.
    ///
    /// # Errors
    ///
    /// The message of the compiler or the system.
    pub fn build(
        board: &[PathBuf],
        made: &[(&str, String)],
        files: &[CFile],
        toolchain: &Toolchain,
    ) -> Result<Self, Error> {
        let (mut own, mut scripts, mut texts) = (Vec::new(), Vec::new(), String::new());
        let mut paths = Vec::new();
        for folder in board {
            for entry in std::fs::read_dir(folder)? {
                paths.push(entry?.path());
            }
        }
        for path in paths {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            match path.extension().and_then(|it| it.to_str()) {
                Some("c" | "h" | "S") => own.push((name, std::fs::read_to_string(&path)?)),
                Some("ld") => scripts.push(path),
                _ => {}
            }
        }
        own.extend(made.iter().map(|(name, text)| ((*name).to_owned(), text.clone())));
        own.sort();
        own.iter().for_each(|(_, text)| texts.push_str(text));
        let emitted = lay_out_needed(files, &texts)?;
        let (mut sources, mut all) = (emitted.sources().to_vec(), BTreeSet::new());
        for (name, text) in own {
            let path = emitted.path().join(&name);
            if emitted.path().join(&name).exists() || !all.insert(name.clone()) {
                let text = format!("`{name}` is a file of the board and one of the emitted C");
                return Err(Error::Compile(text));
            }
            std::fs::write(&path, text)?;
            if !name.ends_with(".h") {
                sources.push(path);
            }
        }
        let folder = emitted.into_folder();
        let program = folder.path().join("firmware.elf");
        let script: Vec<String> =
            scripts.iter().flat_map(|path| ["-T".to_owned(), path.display().to_string()]).collect();
        let script: Vec<&str> = script.iter().map(String::as_str).collect();
        toolchain.firmware(&sources, &program, &script).map_err(Error::Compile)?;
        Ok(Self { program, toolchain: toolchain.clone(), _folder: folder })
    }

    /// Returns the program file, for loading it onto a board.
    pub fn program(&self) -> &Path {
        &self.program
    }

    /// Returns the sizes of the program.
    ///
    /// # Errors
    ///
    /// An error of the system, or no output of the program that reports them.
    pub fn sizes(&self) -> Result<Sizes, Error> {
        self.toolchain.sizes(std::slice::from_ref(&self.program)).map_err(Error::Compile)
    }

    /// Starts the firmware in the emulator. Returns the machine, and its serial line with `patience` as the timeout
    /// of reads.
    ///
    /// # Errors
    ///
    /// An error of the system.
    pub fn start(&self, patience: Duration) -> Result<(Machine, UnixStream), Error> {
        let (here, there) = UnixStream::pair()?;
        here.set_read_timeout(Some(patience))?;
        here.set_write_timeout(Some(patience))?;
        let mut command = self.toolchain.runner(&self.program);
        command.stdin(Stdio::from(OwnedFd::from(there.try_clone()?)));
        command.stdout(Stdio::from(OwnedFd::from(there)));
        Ok((Machine(command.spawn()?), here))
    }
}

/// A running emulator or other program; dropping it ends the program.
#[derive(Debug)]
pub struct Machine(Child);

impl From<Child> for Machine {
    fn from(child: Child) -> Self {
        Self(child)
    }
}

impl Machine {
    /// Returns the number of the process.
    pub fn id(&self) -> u32 {
        self.0.id()
    }

    /// Returns the exit status; `None` while it runs.
    pub fn ended(&mut self) -> Option<String> {
        match self.0.try_wait() {
            Ok(None) => None,
            Ok(Some(status)) => Some(status.to_string()),
            Err(error) => Some(error.to_string()),
        }
    }

    /// Ends the program.
    pub fn kill(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl Drop for Machine {
    fn drop(&mut self) {
        self.kill();
    }
}
