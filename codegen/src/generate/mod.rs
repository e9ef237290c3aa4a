//! The command line's work: a package of models in, a folder of C out.
//!
//! Builds the package in a generation build, runs it for its tree, compiles that, and writes the
//! folder whole or not at all. A user's own `xtask` calls [`generate`] and prints what it returns.
//!
//! Must not know: how C is made, or what a terminal looks like.

mod manifest;
mod output;
mod package;
mod program;
mod report;

use std::path::{Path, PathBuf};

use crate::compile::{self, Compiled, Options};
use crate::diagnostic::{self, Diagnostic};
use crate::source::Sources;

pub use manifest::Manifest;
pub use package::settings;
pub use report::{explanation, table};

/// What to generate, and where to.
#[derive(Clone, Debug)]
pub struct Job {
    /// The root of the workspace.
    pub root: PathBuf,
    /// The package of models.
    pub package: String,
    /// The folder of the C, which belongs to the generator.
    pub output: PathBuf,
    /// Compare instead of writing.
    pub check: bool,
    /// What the user decides about the C.
    pub options: Options,
    /// Colour in diagnostics and differences.
    pub colour: bool,
    /// The version that the manifest names: the tool's.
    pub version: String,
}

impl Job {
    /// Generates `package` of the workspace at `root` into its `generated/`.
    pub fn new(root: impl Into<PathBuf>, package: &str) -> Job {
        let root = root.into();
        let output = root.join("generated");
        let version = env!("CARGO_PKG_VERSION").to_owned();
        let (package, options) = (package.to_owned(), Options::default());
        Job { root, package, output, check: false, options, colour: false, version }
    }
}

/// What was generated.
pub struct Summary {
    /// The models and their C.
    pub compiled: Compiled,
    /// Files written, or that would be: empty when everything was up to date.
    pub changed: Vec<String>,
}

/// Why nothing was generated.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The models do not compile; what rustc said, in the author's terms.
    #[error("{0}")]
    Models(String),
    /// The models compile, but are not what C can be made of.
    #[error("{0}")]
    Refused(String),
    /// The committed C is not what the models give; the differences.
    #[error("{0}")]
    Stale(String),
    /// The folder holds files that the generator did not write.
    #[error("`{folder}` holds `{file}`, which Bessemer did not write")]
    Foreign {
        /// The folder.
        folder: PathBuf,
        /// The first such file.
        file: String,
    },
    /// A program could not be run.
    #[error("cannot run `{program}`: {source}")]
    Run {
        /// Which.
        program: String,
        /// Why.
        source: std::io::Error,
    },
    /// The package's tree could not be read: tool and DSL do not fit together.
    #[error("the tree of `{package}` cannot be read: {reason}")]
    Tree {
        /// The package.
        package: String,
        /// Why.
        reason: String,
    },
    /// A file could not be read or written.
    #[error("`{path}`: {source}")]
    File {
        /// Which.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
}

impl Error {
    /// What to do about it.
    pub fn remedy(&self) -> Option<&'static str> {
        match self {
            Error::Stale(_) => Some("cargo xtask gen"),
            Error::Foreign { .. } => Some("move it elsewhere, or generate into another folder"),
            Error::Tree { .. } => {
                Some("use the same version of `bessemer` and of `bessemer-codegen`")
            }
            _ => None,
        }
    }
}

/// Does the job.
///
/// # Errors
/// See [`Error`]; on any of them the folder is as it was.
pub fn generate(job: &Job) -> Result<Summary, Error> {
    let sources = Sources::new(&job.root);
    let package = package::tree(job, &sources)?;
    let compiled = compile::compile(&package, &sources, &job.options)
        .map_err(|diagnostics| refused(job, &diagnostics, &sources))?;
    let mut files = output::Files::default();
    for file in &compiled.files {
        files.add(&file.name, file.text.clone());
        if let Some((name, text)) = manifest::map(file) {
            files.add(&name, text);
        }
    }
    let manifest = Manifest::new(&compiled, &files, &job.version);
    let changed = if job.check {
        output::check(&job.output, &files, &manifest, job.colour)?;
        Vec::new()
    } else {
        output::write(&job.output, files, &manifest)?
    };
    Ok(Summary { compiled, changed })
}

/// Builds the package and gives its tree; for tools that go on from there.
///
/// # Errors
/// See [`Error`].
pub fn tree(root: &Path, package: &str) -> Result<bessemer_ir::tree::Package, Error> {
    package::tree(&Job::new(root, package), &Sources::new(root))
}

fn refused(job: &Job, diagnostics: &[Diagnostic], sources: &Sources) -> Error {
    Error::Refused(diagnostic::render(diagnostics, sources, job.colour))
}
