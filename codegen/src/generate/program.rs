//! The program that prints a package's tree, as cargo built it, and whether it is this workspace's.
//!
//! Where workspaces share a target folder, cargo takes what was built of another's package of the same
//! name for this one's if that is newer than the sources. So the program says first in which folder each
//! crate was compiled, and what was compiled elsewhere is built anew.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs::File;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

use serde_json::Value;

use super::error::Error;

/// The program, and the crates that it is made of.
pub(super) struct Program {
    path: PathBuf,
    artifacts: Vec<Artifact>,
}

/// What cargo said that it built.
struct Artifact {
    /// The name of the crate.
    krate: String,
    /// The folder of its package.
    folder: PathBuf,
    /// Its first source file.
    source: PathBuf,
}

/// What the program printed.
pub(super) struct Printed {
    /// Whether it came to its end.
    pub success: bool,
    /// The tree.
    pub tree: String,
    /// What it said of an error.
    pub error: String,
    /// The first source files of the crates that were compiled in another workspace instead.
    pub strangers: Vec<PathBuf>,
}

impl Program {
    /// The program `binary`, by cargo's messages; none if it is not among them.
    pub fn of(messages: &[Value], binary: &str) -> Option<Program> {
        let path = messages.iter().find_map(|message| executable(message, binary))?;
        Some(Program { path, artifacts: messages.iter().filter_map(Artifact::of).collect() })
    }

    /// Runs it; nothing if another workspace has removed it since.
    pub fn run(&self) -> Result<Option<Printed>, Error> {
        let output = match Command::new(&self.path).output() {
            Ok(output) => output,
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
            Err(source) => {
                return Err(Error::Run { program: self.path.display().to_string(), source });
            }
        };
        let text = String::from_utf8_lossy(&output.stdout);
        let (folders, tree) = text.split_once('\n').unwrap_or_default();
        Ok(Some(Printed {
            success: output.status.success(),
            tree: tree.to_owned(),
            error: String::from_utf8_lossy(&output.stderr).trim().to_owned(),
            strangers: self.strangers(folders),
        }))
    }

    /// The sources of the crates that were compiled in other folders than cargo says.
    fn strangers(&self, folders: &str) -> Vec<PathBuf> {
        let folders: BTreeMap<String, PathBuf> = serde_json::from_str(folders).unwrap_or_default();
        let built = |krate: &str| -> Vec<&Artifact> {
            self.artifacts.iter().filter(|it| it.krate == krate).collect()
        };
        let mut strangers = Vec::new();
        for (krate, folder) in &folders {
            let built = built(krate);
            if built.iter().all(|it| !is_same(&it.folder, folder)) {
                strangers.extend(built.iter().map(|it| it.source.clone()));
            }
        }
        strangers
    }
}

impl Artifact {
    fn of(message: &Value) -> Option<Artifact> {
        let folder = Path::new(message.get("manifest_path")?.as_str()?).parent()?.to_owned();
        let krate = message.get("target")?.get("name")?.as_str()?.replace('-', "_");
        let source = PathBuf::from(message.get("target")?.get("src_path")?.as_str()?);
        (message["reason"] == "compiler-artifact").then_some(Artifact { krate, folder, source })
    }
}

/// Whether two paths lead to one folder.
fn is_same(one: &Path, other: &Path) -> bool {
    let real = |path: &Path| path.canonicalize().ok();
    one == other || real(one).is_some_and(|one| real(other) == Some(one))
}

fn executable(message: &Value, binary: &str) -> Option<PathBuf> {
    let target = message.get("target")?.get("name")?.as_str()?;
    let program = message.get("executable")?.as_str()?;
    (target == binary).then(|| PathBuf::from(program))
}

/// Makes cargo compile a crate anew, by the time of its first source file: cleaning would also take away
/// what others have built.
pub(super) fn touch(source: &Path) -> Result<(), Error> {
    let now = SystemTime::now();
    let touched = File::options().append(true).open(source).and_then(|file| file.set_modified(now));
    touched.map_err(|error| Error::File { path: source.to_owned(), source: error })
}

/// The cargo that runs this, or the one on the path.
pub(super) fn cargo() -> OsString {
    std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into())
}
