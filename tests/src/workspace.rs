//! A workspace of its own in a temporary folder, as a user outside this repository has one.
//!
//! It takes this workspace's settings, lock file and target folder, and links to the DSL: only its models are built
//! anew, and these only if the same was not built before. What it generates must not depend on where it lies.

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::{Path, PathBuf};

use bessemer_codegen::compile::{self, Compiled};
use bessemer_codegen::generate::{self, Job, Made, Summary, Tree};
use bessemer_frontend::diagnostic;
use bessemer_frontend::source::Sources;
use bessemer_legs::trees;
use tempfile::TempDir;

use crate::root;

/// Settings of the package that is rebuilt often with small changes, and runs for a moment.
const SETTINGS: &str = "[profile.dev.package.models]\nopt-level = 2\n";
/// In place of it: with cargo's notes for the next build, which takes a third of the time then, even where a run goes without.
const OWN_SETTINGS: &str = "[profile.dev.package.models]\nincremental = true\n";

/// The folder of the package `models`: not that of this workspace's, or cargo would take it for that one.
const FOLDER: &str = "controllers";

/// Generated files by name.
pub type Files = BTreeMap<String, String>;

/// A workspace with one package of models, `models`.
pub struct Workspace(TempDir);

impl Workspace {
    /// With a copy of the flight models.
    ///
    /// # Errors
    /// An error of the file system.
    pub fn with_flight_models() -> std::io::Result<Workspace> {
        let workspace = Workspace::bare()?;
        copy_folder(&root().canonicalize()?.join("models"), &workspace.folder())?;
        Ok(workspace)
    }

    /// With one source file.
    ///
    /// # Errors
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

    /// Without a package yet: one whose folder is called so, or begins so, belongs to it.
    ///
    /// # Errors
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

    /// Cargo takes a linked package for the one that the link leads to, by its path in the workspace, and builds it once.
    fn bare() -> std::io::Result<Workspace> {
        let root = root().canonicalize()?;
        let workspace = Workspace(tempfile::tempdir()?);
        fs::copy(root.join("Cargo.lock"), workspace.path("Cargo.lock"))?;
        symlink(root.join("dsl"), workspace.path("dsl"))?;
        let text = fs::read_to_string(root.join("Cargo.toml"))?;
        let members = text.lines().find(|line| line.starts_with("members")).unwrap_or_default();
        let text = text
            .replace(members, &format!("members = [\"{FOLDER}\"]"))
            .replace("path = \"models\"", &format!("path = \"{FOLDER}\""))
            .replace(SETTINGS, OWN_SETTINGS);
        assert!(text.contains("incremental = true"), "the workspace says nothing of its models");
        fs::write(workspace.path("Cargo.toml"), text)?;
        fs::create_dir(workspace.path(".cargo"))?;
        let target = root.join("target");
        let config = format!("[build]\ntarget-dir = \"{}\"\n", target.display());
        fs::write(workspace.path(".cargo/config.toml"), config)?;
        Ok(workspace)
    }

    /// The folder of its package.
    pub fn folder(&self) -> PathBuf {
        self.path(FOLDER)
    }

    /// A path in the workspace.
    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
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

    /// The job of generating its package.
    pub fn job(&self) -> Job {
        Job::new(self.path(""), "models")
    }

    /// The tree of its package.
    ///
    /// # Errors
    /// See [`generate::Error`].
    pub fn tree(&self) -> Result<Tree, generate::Error> {
        trees::tree(&self.job(), &[self.folder()])
    }

    /// The models, compiled.
    ///
    /// # Errors
    /// What the generator or the compiler said.
    pub fn compiled(&self) -> Result<Compiled, String> {
        self.compiled_with(&compile::Options::default())
    }

    /// Compiles the package with options.
    ///
    /// # Errors
    /// What the generator or the compiler said.
    pub fn compiled_with(&self, options: &compile::Options) -> Result<Compiled, String> {
        let sources = Sources::new(self.path(""));
        let package = self.tree().map_err(|error| error.to_string())?.package;
        compile::compile(&package, &sources, options)
            .map_err(|errors| diagnostic::render(&errors, &sources, false))
    }

    /// Does a job of its package's.
    ///
    /// # Errors
    /// See [`generate::Error`].
    pub fn perform(&self, job: &Job) -> Result<Summary, generate::Error> {
        let Made { compiled, remarks } = generate::compiled_from(job, &self.tree()?)?;
        let changed = generate::deliver(job, &compiled)?;
        Ok(Summary { compiled, changed, remarks })
    }

    /// Generates with a tool that says it is of `version`; the folder's files.
    ///
    /// # Errors
    /// What the generator said.
    pub fn generate(&self, version: &str) -> Result<Files, generate::Error> {
        let mut job = self.job();
        job.version = version.to_owned();
        self.perform(&job)?;
        self.generated()
    }

    /// Does the same by a build of its own, even if the same was built before.
    ///
    /// # Errors
    /// What the generator said.
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
