//! `cargo bessemer where`: the Rust of a line of C, and the C of a line of Rust.

use std::path::Path;

use bessemer_dossier::trace::{self, Folder, Line, Workspace};
use bessemer_project::Project;

use crate::args::Where;
use crate::error::Error;

/// Returns the counterpart of a line, with the text of both.
///
/// # Errors
/// The package is not found, its C is not generated, or the line has no counterpart.
pub fn run(folder: &Path, wanted: &Where, colour: bool) -> Result<String, Error> {
    let line = Line::of(&wanted.line)?;
    let project = Project::find(folder, wanted.package.name(), colour)?;
    let c = Folder::read(&project.job(colour).output)?;
    Ok(trace::described(&c, &Workspace(&project.workspace.root), &line)?)
}
