//! The command line's work: a package of models in, a folder of C out.
//!
//! Builds the package in a generation build, runs it for its tree, compiles that, and writes the
//! folder whole or not at all. A user's own `xtask` calls [`generate`] and prints what it returns.
//!
//! Must not know: how C is made, or what a terminal looks like.

mod error;
mod files;
mod job;
mod manifest;
mod output;
mod package;
mod program;
mod report;

use std::path::Path;

use crate::compile::{self, Compiled};
use crate::diagnostic::{self, Diagnostic};
use crate::source::Sources;

pub use error::Error;
pub use job::Job;
pub use manifest::Manifest;
pub use package::settings;
pub use report::{explanation, table};

/// What was generated.
pub struct Summary {
    /// The models and their C.
    pub compiled: Compiled,
    /// Files written, or that would be: empty when everything was up to date.
    pub changed: Vec<String>,
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
    let mut files = files::Files::default();
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
