//! A program around a package, such as that which prints its tree: linked with what cargo built, and whether that is
//! this workspace's.
//!
//! Where workspaces share a target folder, cargo takes what was built of another's package of the same
//! name for this one's if that is newer than the sources. So the program of a generation build says first in which folder each
//! crate was compiled, and what was compiled elsewhere is built anew. Of a native build, which says nothing, all is built anew
//! that may be another's.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

use serde_json::Value;
use tempfile::TempDir;

use super::error::Error;

/// The program that cargo built.
pub(super) struct Built {
    artifacts: Vec<Artifact>,
}

/// The program, in a folder of its own, and the crates that it is made of.
pub struct Program {
    folder: TempDir,
    artifacts: Vec<Artifact>,
}

/// The artifacts that cargo's messages name.
struct Artifact {
    /// The name of the crate.
    krate: String,
    /// The folder of its package.
    folder: PathBuf,
    /// Its first source file.
    source: PathBuf,
    /// The library, if other Rust can be linked with it.
    library: Option<PathBuf>,
    /// True if cargo found it already built.
    found: bool,
}

/// The output of the program.
pub(super) struct Printed {
    /// True if it succeeded.
    pub success: bool,
    /// The tree.
    pub tree: String,
    /// Its error output.
    pub error: String,
    /// The first source files of the crates that were compiled in another workspace instead.
    pub strangers: Vec<PathBuf>,
    /// Source of the package's library if nothing in it is marked: such a library does not report where it was
    /// compiled.
    pub silent: Option<PathBuf>,
}

impl Built {
    /// The artifacts, by cargo's messages.
    pub fn of(messages: &[Value]) -> Built {
        Built { artifacts: messages.iter().filter_map(Artifact::of).collect() }
    }

    /// Returns the first source files of the libraries in the folder `root` that cargo found already built. It is
    /// unknown whether they were built from these sources or from another workspace's.
    pub fn found_in(&self, root: &Path) -> Vec<PathBuf> {
        let real = |path: &Path| path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let root = real(root);
        let found = self.artifacts.iter().filter(|it| it.found && it.library.is_some());
        found.filter(|it| real(&it.folder).starts_with(&root)).map(|it| it.source.clone()).collect()
    }

    /// Links a program with a package's `library` and the DSL: `text`, with the variables that it reads when it is
    /// compiled. Or what rustc said, in a line each: where another workspace has built into the same folder meanwhile, or
    /// where the text is at fault.
    pub fn link(
        self,
        root: &Path,
        library: &str,
        text: &str,
        variables: &[(&str, &str)],
    ) -> Result<Result<Program, String>, Error> {
        let folder = tempfile::tempdir()
            .map_err(|source| Error::File { path: std::env::temp_dir(), source })?;
        let source = folder.path().join("program.rs");
        std::fs::write(&source, text)
            .map_err(|error| Error::File { path: source.clone(), source: error })?;
        let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let mut command = Command::new(&rustc);
        command
            .args(["--edition", "2024", "--crate-name", "program", "--error-format", "short", "-o"])
            .arg(folder.path().join("program"))
            .arg(&source)
            .current_dir(root)
            .envs(variables.iter().copied());
        for name in [library, "bessemer"] {
            let found = self.artifacts.iter().find(|it| it.krate == name && it.library.is_some());
            let Some(built) = found.and_then(|it| it.library.as_deref()) else {
                return Ok(Err(format!("cargo built no library `{name}`")));
            };
            let parts = [name.as_ref(), "=".as_ref(), built.as_os_str()];
            command.arg("--extern").arg(OsString::from_iter(parts));
            let beside = built.parent().unwrap_or(built);
            for folder in [beside.to_owned(), beside.join("deps")] {
                let parts = ["dependency=".as_ref(), folder.as_os_str()];
                command.arg("-L").arg(OsString::from_iter(parts));
            }
        }
        let output = command.output().map_err(|source| Error::Run {
            program: rustc.to_string_lossy().into_owned(),
            source,
        })?;
        Ok(match output.status.success() {
            true => Ok(Program { folder, artifacts: self.artifacts }),
            false => Err(String::from_utf8_lossy(&output.stderr).trim().to_owned()),
        })
    }
}

impl Program {
    /// Returns the path.
    pub fn path(&self) -> PathBuf {
        self.folder.path().join("program")
    }

    /// Runs it.
    pub(super) fn run(&self, library: &str) -> Result<Printed, Error> {
        let path = self.path();
        let output = Command::new(&path)
            .env("RUST_BACKTRACE", "0")
            .output()
            .map_err(|source| Error::Run { program: path.display().to_string(), source })?;
        let text = String::from_utf8_lossy(&output.stdout);
        let (folders, tree) = text.split_once('\n').unwrap_or_default();
        let folders: BTreeMap<String, PathBuf> = serde_json::from_str(folders).unwrap_or_default();
        let own = self.artifacts.iter().find(|it| it.krate == library);
        Ok(Printed {
            success: output.status.success(),
            tree: tree.to_owned(),
            error: String::from_utf8_lossy(&output.stderr).trim().to_owned(),
            strangers: self.strangers(&folders),
            silent: own.filter(|_| !folders.contains_key(library)).map(|it| it.source.clone()),
        })
    }

    /// The sources of the crates that were compiled in other folders than cargo says.
    fn strangers(&self, folders: &BTreeMap<String, PathBuf>) -> Vec<PathBuf> {
        let built = |krate: &str| -> Vec<&Artifact> {
            self.artifacts.iter().filter(|it| it.krate == krate).collect()
        };
        let mut strangers = Vec::new();
        for (krate, folder) in folders {
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
        let target = message.get("target")?;
        let krate = target.get("name")?.as_str()?.replace('-', "_");
        let source = PathBuf::from(target.get("src_path")?.as_str()?);
        let files = message["filenames"].as_array().into_iter().flatten();
        let files: Vec<PathBuf> = files.filter_map(Value::as_str).map(PathBuf::from).collect();
        let of = |kind: &str| files.iter().find(|it| it.extension().is_some_and(|it| it == kind));
        // Beside the metadata it has a name of its own; its other name, packages of one name share.
        let own = of("rmeta").map(|it| it.with_extension("rlib")).filter(|it| it.exists());
        let library = of("rlib").cloned().map(|shared| own.unwrap_or(shared));
        let built = message["reason"] == "compiler-artifact";
        let found = message["fresh"] == true;
        built.then_some(Artifact { krate, folder, source, library, found })
    }
}

/// Returns true if two paths lead to one folder.
fn is_same(one: &Path, other: &Path) -> bool {
    let real = |path: &Path| path.canonicalize().ok();
    one == other || real(one).is_some_and(|one| real(other) == Some(one))
}

/// Makes cargo compile a crate anew, by the time of its first source file: cleaning would also take away
/// what others have built.
pub(super) fn touch(source: &Path) -> Result<(), Error> {
    let now = SystemTime::now();
    let touched = File::options().append(true).open(source).and_then(|file| file.set_modified(now));
    touched.map_err(|error| Error::File { path: source.to_owned(), source: error })
}
