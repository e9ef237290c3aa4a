//! A workspace in a temporary folder, such as a user outside this repository has.
//!
//! It uses this workspace's settings, lock file and target folder, and links to the DSL, so that only its models are
//! built, and only if the same were not built before. The generated files must not depend on its path.

use std::collections::BTreeMap;
use std::env;
use std::fs::{self, File};
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_codegen::compile::{self, Compiled};
use bessemer_codegen::generate::{self, Job, Made, Summary, Tree};
use bessemer_frontend::diagnostic;
use bessemer_frontend::source::Sources;
use bessemer_legs::trees;
use tempfile::TempDir;

use crate::{root, toolchain};

/// Profile settings for a package that is rebuilt often with small changes, and whose program runs only briefly.
const SETTINGS: &str = "[profile.dev.package.models]\nopt-level = 2\n";
/// Profile settings with cargo's incremental builds, for a workspace's own target folder. Later builds take a third of
/// the time.
const OWN_SETTINGS: &str = "[profile.dev.package.models]\nincremental = true\n";

/// Folder of the package `models`. It differs from this workspace's, or cargo would take the two for one package.
const FOLDER: &str = "controllers";

/// Generated files by name.
pub type Files = BTreeMap<String, String>;

/// A workspace with one package of models, `models`.
pub struct Workspace {
    root: TempDir,
    target: PathBuf,
}

impl Workspace {
    /// Creates a workspace with a copy of the flight models.
    ///
    /// # Errors
    ///
    /// An error of the file system.
    pub fn with_flight_models() -> std::io::Result<Workspace> {
        let workspace = Workspace::bare()?;
        copy_folder(&root().canonicalize()?.join("models"), &workspace.folder())?;
        Ok(workspace)
    }

    /// Creates a workspace with one source file.
    ///
    /// # Errors
    ///
    /// An error of the file system.
    pub fn with_source(text: &str) -> std::io::Result<Workspace> {
        let workspace = Workspace::bare()?;
        let models = root().canonicalize()?.join("models");
        fs::create_dir_all(workspace.folder().join("src/bin"))?;
        fs::copy(models.join("Cargo.toml"), workspace.folder().join("Cargo.toml"))?;
        workspace.set_source(text)?;
        Ok(workspace)
    }

    /// Replaces the settings of its package's profile.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn set_profiles(&self, settings: &str) -> std::io::Result<()> {
        let manifest = self.path("Cargo.toml");
        let text = fs::read_to_string(&manifest)?;
        fs::write(manifest, text.replace(OWN_SETTINGS, settings))
    }

    /// Creates a workspace without a package; a package whose folder has this name, or begins with it, will belong to
    /// it.
    ///
    /// # Errors
    ///
    /// An error of the file system.
    pub fn for_package(name: &str) -> std::io::Result<Workspace> {
        let workspace = Workspace::bare()?;
        let manifest = workspace.path("Cargo.toml");
        let text = fs::read_to_string(&manifest)?;
        fs::write(manifest, text.replace(&format!("[\"{FOLDER}\"]"), &format!("[\"{name}*\"]")))?;
        Ok(workspace)
    }

    /// Replaces the one source file.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn set_source(&self, text: &str) -> std::io::Result<()> {
        fs::write(self.folder().join("src/lib.rs"), text)
    }

    /// Creates a workspace with links to the DSL. Cargo identifies a linked package with the original, and builds it
    /// once.
    fn bare() -> std::io::Result<Workspace> {
        let root = root().canonicalize()?;
        let target = root.join("target");
        let workspace = Workspace { root: tempfile::tempdir()?, target: target.clone() };
        fs::copy(root.join("Cargo.lock"), workspace.path("Cargo.lock"))?;
        for folder in ["legs", "sim"] {
            fs::create_dir(workspace.path(folder))?;
        }
        for linked in ["dsl", "estimation", "blocks", "legs/words", "sim/campaign", "sim/kit"] {
            symlink(root.join(linked), workspace.path(linked))?;
        }
        let text = fs::read_to_string(root.join("Cargo.toml"))?;
        let members = text.lines().find(|line| line.starts_with("members")).unwrap_or_default();
        let text = text
            .replace(members, &format!("members = [\"{FOLDER}\"]"))
            .replace("path = \"models\"", &format!("path = \"{FOLDER}\""))
            .replace(SETTINGS, OWN_SETTINGS);
        assert!(text.contains("incremental = true"), "the workspace says nothing of its models");
        fs::write(workspace.path("Cargo.toml"), text)?;
        fs::create_dir(workspace.path(".cargo"))?;
        workspace.with_target(target)
    }

    /// Replaces the target folder. In one of its own, a workspace is built while others are, and its dependencies once more.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn with_target(mut self, target: PathBuf) -> std::io::Result<Workspace> {
        fs::create_dir_all(&target)?;
        let target = target.canonicalize()?;
        let config = format!("[build]\ntarget-dir = \"{}\"\n", target.display());
        fs::write(self.path(".cargo/config.toml"), config)?;
        self.target = target;
        Ok(self)
    }

    /// Waits until no other run builds into the target folder or links from it, and keeps others out until the result is
    /// dropped. Packages of one name and relative path have one library there, so whoever calls cargo directly needs it.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn alone(&self) -> std::io::Result<File> {
        let file = File::create(self.target.join(".bessemer-lock"))?;
        file.lock().map(|()| file)
    }

    /// Runs one test of a package in it, alone: two packages of one name and folder have one test program, too.
    ///
    /// # Errors
    /// The output of a test that failed, or the text of an error of the file system.
    pub fn run_test(&self, package: &Path, test: &str) -> Result<(), String> {
        let _alone = self.alone().map_err(|error| error.to_string())?;
        let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        let words = ["test", "--quiet", "--offline", "--test", test];
        toolchain::run(cargo.args(words).current_dir(package))
    }

    /// Returns the folder of its package.
    pub fn folder(&self) -> PathBuf {
        self.path(FOLDER)
    }

    /// Returns a path in the workspace.
    pub fn path(&self, name: &str) -> PathBuf {
        self.root.path().join(name)
    }

    /// Replaces `old` by `new` in each source file of the models that has it.
    ///
    /// # Panics
    /// If none has it: the test would test nothing.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn replace(&self, old: &str, new: &str) -> std::io::Result<()> {
        let mut found = false;
        for entry in fs::read_dir(self.folder().join("src"))? {
            let path = entry?.path();
            if path.is_file() {
                let text = fs::read_to_string(&path)?;
                found |= text.contains(old);
                fs::write(path, text.replace(old, new))?;
            }
        }
        assert!(found, "`{old}` is not in the models");
        Ok(())
    }

    /// Returns the job of generating its package.
    pub fn job(&self) -> Job {
        Job::new(self.path(""), "models")
    }

    /// Returns the tree of its package.
    ///
    /// # Errors
    ///
    /// See [`generate::Error`].
    pub fn tree(&self) -> Result<Tree, generate::Error> {
        trees::tree(&self.job(), &[self.folder()])
    }

    /// Compiles its package.
    ///
    /// # Errors
    ///
    /// The message of the generator or the compiler.
    pub fn compiled(&self) -> Result<Compiled, String> {
        self.compiled_with(&compile::Options::default())
    }

    /// Compiles its package with options.
    ///
    /// # Errors
    ///
    /// The message of the generator or the compiler.
    pub fn compiled_with(&self, options: &compile::Options) -> Result<Compiled, String> {
        let sources = Sources::new(self.path(""));
        let package = self.tree().map_err(|error| error.to_string())?.package;
        compile::compile(&package, &sources, options)
            .map_err(|errors| diagnostic::render(&errors, &sources, false))
    }

    /// Performs a job for its package.
    ///
    /// # Errors
    ///
    /// See [`generate::Error`].
    pub fn perform(&self, job: &Job) -> Result<Summary, generate::Error> {
        let Made { compiled, remarks } = generate::compiled_from(job, &self.tree()?)?;
        let changed = generate::deliver(job, &compiled)?;
        Ok(Summary { compiled, changed, remarks })
    }

    /// Generates with a tool of `version`; returns the folder's files.
    ///
    /// # Errors
    ///
    /// The message of the generator.
    pub fn generate(&self, version: &str) -> Result<Files, generate::Error> {
        let mut job = self.job();
        job.version = version.to_owned();
        self.perform(&job)?;
        self.generated()
    }

    /// Generates with a separate build, even if a stored result exists.
    ///
    /// # Errors
    ///
    /// The message of the generator.
    pub fn generate_anew(&self, version: &str) -> Result<Files, generate::Error> {
        let mut job = self.job();
        job.version = version.to_owned();
        generate::generate(&job)?;
        self.generated()
    }

    fn generated(&self) -> Result<Files, generate::Error> {
        let output = self.job().output;
        let read = |source| generate::Error::File { path: output.clone(), source };
        let mut files = Files::new();
        for entry in fs::read_dir(&output).map_err(read)? {
            let entry = entry.map_err(read)?;
            let text = fs::read_to_string(entry.path()).map_err(read)?;
            files.insert(entry.file_name().to_string_lossy().into_owned(), text);
        }
        Ok(files)
    }
}

fn copy_folder(from: &Path, to: &Path) -> std::io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let path = entry?.path();
        let target = to.join(path.file_name().unwrap_or_default());
        if path.is_dir() {
            copy_folder(&path, &target)?;
        } else {
            fs::copy(&path, &target)?;
        }
    }
    Ok(())
}
