//! Generates a folder of C from a package of models.
//!
//! Builds the package in a generation build, runs it to get its tree, compiles the tree, and replaces the folder as a
//! whole. `cargo bessemer` and an `xtask` call [`generate`] and print its result.
//!
//! Must not know: the compiler's stages, or the terminal.

mod error;
mod files;
mod job;
mod manifest;
mod output;
mod package;
mod program;
mod report;
mod reported;
mod workspace;

use crate::compile::{self, Compiled};
use crate::derivatives::{self, Edit};
use crate::remarks;
use bessemer_frontend::diagnostic::{Diagnostic, Told};
use bessemer_frontend::source::Sources;

pub use error::Error;
pub use job::Job;
pub use manifest::Manifest;
pub use package::{Tree, settings};
pub use program::Program;
pub use report::{Left, explanation, left, table};
pub use workspace::{Member, Workspace};

/// Result of a generation.
pub struct Summary {
    /// Compiled package.
    pub compiled: Compiled,
    /// Files that were written or, with `check`, would be; empty if the folder was up to date.
    pub changed: Vec<String>,
    /// Warnings for the author of the models.
    pub remarks: Told,
}

/// A compiled package that is not written yet.
pub struct Made {
    /// Compiled package.
    pub compiled: Compiled,
    /// Warnings for the author of the models.
    pub remarks: Told,
}

/// Generates the C of a job.
///
/// # Errors
///
/// See [`Error`]; after an error the folder is unchanged.
pub fn generate(job: &Job) -> Result<Summary, Error> {
    let Made { compiled, remarks } = compiled_from(job, &renewed(job)?)?;
    let changed = deliver(job, &compiled)?;
    Ok(Summary { compiled, changed, remarks })
}

/// Checks before a long build that the job's folder may be replaced, judging by its contents.
///
/// # Errors
/// [`Error::Foreign`], [`Error::Other`], [`Error::NotAFolder`] or [`Error::File`].
pub fn ready(job: &Job) -> Result<(), Error> {
    output::ready(&job.output, &job.package)
}

/// Compiles the job's package, and writes nothing.
///
/// # Errors
/// See [`Error`].
pub fn compiled(job: &Job) -> Result<Made, Error> {
    compiled_from(job, &tree(job)?)
}

/// Compiles the tree of the job's package, and writes nothing.
///
/// # Errors
/// See [`Error`].
pub fn compiled_from(job: &Job, tree: &Tree) -> Result<Made, Error> {
    let sources = Sources::new(&job.root);
    let Tree { package, warnings } = tree;
    if package.types.is_empty() && package.functions.is_empty() && package.errors.is_empty() {
        let reasons: Vec<Diagnostic> = remarks::reasons(package).collect();
        return Err(match reasons.is_empty() {
            true => Error::NoModels { package: job.package.clone() },
            false => refused(job, reasons, &sources),
        });
    }
    let compiled = compile::compile(package, &sources, &job.options)
        .map_err(|diagnostics| refused(job, diagnostics, &sources))?;
    let found = remarks::of(package, &compiled.module);
    let alike = remarks::alike(&compiled.explicit, &job.options);
    let remarks = warnings.iter().cloned().chain(found).chain(alike).collect();
    Ok(Made { compiled, remarks: Told::new(remarks, &sources, job.colour) })
}

/// Returns the tree of the job's package, once the bodies of its derivatives are those of the functions. With
/// [`Job::check`] it compares them.
///
/// # Errors
/// See [`Error`].
pub fn renewed(job: &Job) -> Result<Tree, Error> {
    let tree = tree(job)?;
    let sources = Sources::new(&job.root);
    let edits = derivatives::edits(&tree.package, &sources)
        .map_err(|diagnostics| refused(job, diagnostics, &sources))?;
    if edits.is_empty() {
        return Ok(tree);
    }
    if job.check {
        let shown =
            edits.iter().map(|it| output::difference(&it.file, &it.before, &it.after, job.colour));
        return Err(Error::Stale(shown.collect()));
    }
    for Edit { file, after, .. } in edits {
        let path = job.root.join(file);
        std::fs::write(&path, after).map_err(|source| Error::File { path, source })?;
    }
    self::tree(job)
}

/// Writes the C to the job's folder, or compares it; returns the names of the changed files.
///
/// # Errors
///
/// See [`Error`]; after an error the folder is unchanged.
pub fn deliver(job: &Job, compiled: &Compiled) -> Result<Vec<String>, Error> {
    let mut files = files::Files::default();
    for file in &compiled.files {
        files.add(&file.name, file.text.clone());
        if let Some((name, text)) = manifest::map(file) {
            files.add(&name, text);
        }
    }
    let manifest = Manifest::new(compiled, &files, &job.version);
    if job.check {
        output::check(&job.output, &files, &manifest, job.colour)?;
        return Ok(Vec::new());
    }
    // Beside the lock of builds, which take longer than this.
    let _alone = Workspace::of(&job.root)?.alone(".bessemer-written")?;
    output::write(&job.output, files, &manifest)
}

/// Builds a native program from `text`, linked with the job's package. Returns rustc's messages, one per line, if the
/// text does not compile.
///
/// # Errors
///
/// See [`Error`].
pub fn native(job: &Job, text: &str, names: bool) -> Result<Result<Program, String>, Error> {
    let (workspace, sources) = (Workspace::of(&job.root)?, Sources::new(&job.root));
    package::native(job, &workspace, &sources, (text, names))
}

/// Builds the job's package and returns its tree, for other tools.
///
/// # Errors
///
/// See [`Error`].
pub fn tree(job: &Job) -> Result<Tree, Error> {
    package::tree(job, &Workspace::of(&job.root)?, &Sources::new(&job.root))
}

fn refused(job: &Job, diagnostics: Vec<Diagnostic>, sources: &Sources) -> Error {
    Error::Refused(Told::new(diagnostics, sources, job.colour))
}
