//! Programs linked with a package, such as the one that prints its tree; and the check that the package is this
//! workspace's.
//!
//! If workspaces share a target folder, cargo uses the build of another package with the same name if it is newer
//! than the sources. So the program of a generation build first prints the folder in which each crate was compiled,
//! and crates from other folders are rebuilt. A native program prints nothing, so all crates that may be another
//! workspace's are rebuilt.

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

use serde_json::Value;
use tempfile::TempDir;

use super::error::Error;

/// Artifacts of a build.
pub(super) struct Built {
    artifacts: Vec<Artifact>,
}

/// A linked program in a temporary folder, with its crates.
pub struct Program {
    folder: TempDir,
    artifacts: Vec<Artifact>,
}

/// An artifact of cargo's messages.
struct Artifact {
    /// Name of the crate.
    krate: String,
    /// Folder of its package.
    folder: PathBuf,
    /// Root source file.
    source: PathBuf,
    /// Library file, if Rust code can be linked with it.
    library: Option<PathBuf>,
    /// True if cargo did not rebuild it.
    found: bool,
}

/// The output of the program.
pub(super) struct Printed {
    /// True if it succeeded.
    pub success: bool,
    /// Standard output: the tree.
    pub tree: String,
    /// Standard error.
    pub error: String,
    /// Root source files of crates that were compiled in another workspace.
    pub strangers: Vec<PathBuf>,
    /// Source of the package's library if nothing in it is marked: such a library does not report where it was
    /// compiled.
    pub silent: Option<PathBuf>,
}

impl Built {
    /// Returns the artifacts in cargo's messages.
    pub fn of(messages: &[Value]) -> Built {
        Built { artifacts: messages.iter().filter_map(Artifact::of).collect() }
    }

    /// Returns the root source files of the libraries in the folder `root` that cargo did not rebuild. It is unknown
    /// if they were built from these sources or from another workspace's.
    pub fn found_in(&self, root: &Path) -> Vec<PathBuf> {
        let real = |path: &Path| path.canonicalize().unwrap_or_else(|_| path.to_owned());
        let root = real(root);
        let found = self.artifacts.iter().filter(|it| it.found && it.library.is_some());
        found.filter(|it| real(&it.folder).starts_with(&root)).map(|it| it.source.clone()).collect()
    }

    /// Links the program `text` with a package's `library` and the DSL, with these environment variables at compile
    /// time. Returns rustc's messages, one per line, if another workspace has built into the folder meanwhile, or if
    /// the text is wrong.
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

    /// Runs the program.
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

    /// Returns the sources of the crates that were compiled in other folders than cargo reports.
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

/// Returns true if two paths denote the same folder.
fn is_same(one: &Path, other: &Path) -> bool {
    let real = |path: &Path| path.canonicalize().ok();
    one == other || real(one).is_some_and(|one| real(other) == Some(one))
}

/// Makes cargo rebuild a crate, by a new time stamp of its root source file. `cargo clean` would also remove other
/// builds.
pub(super) fn touch(source: &Path) -> Result<(), Error> {
    let now = SystemTime::now();
    let touched = File::options().append(true).open(source).and_then(|file| file.set_modified(now));
    touched.map_err(|error| Error::File { path: source.to_owned(), source: error })
}
