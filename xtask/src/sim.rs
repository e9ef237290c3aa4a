//! `cargo xtask sim`, `identify` and `campaign`: hand over to the program of the `sim` crate.
//!
//! Invariant: it is a program of its own, so that a fault in a model never keeps xtask from building; and it
//! is built with optimisation, so that a flight takes a moment.
//!
//! What it must not know: the plant, the flights' contents.

use crate::args::Forwarded;
use crate::error::{Error, Outcome};
use crate::{project, stages};
use std::path::Path;

/// Runs a command of the program.
///
/// # Errors
/// [`Error::Spawn`] if cargo does not start.
pub fn run(root: &Path, task: &str, wanted: &Forwarded) -> Result<Outcome, Error> {
    let run = ["run", "--quiet", "--release", "--package", "sim", "--", task];
    let mut command = project::cargo(root, &run);
    command.args(&wanted.rest);
    let status = stages::attached(&mut command)?;
    Ok(if status.success() { Outcome::Good } else { Outcome::Bad })
}
