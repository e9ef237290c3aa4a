//! `cargo xtask sim`: hands over to the program of the `sim` crate.
//!
//! Invariant: it is a program of its own, so that a fault in a model never keeps xtask from building.
//!
//! What it must not know: the plant, the flights' contents.

use crate::args::Sim;
use crate::error::{Error, Outcome};
use crate::{project, stages};
use std::path::Path;

/// Flies the flight that was asked for.
///
/// # Errors
/// [`Error::Spawn`] if cargo does not start.
pub fn run(root: &Path, wanted: &Sim) -> Result<Outcome, Error> {
    let mut command = project::cargo(root, &["run", "--quiet", "--package", "sim", "--"]);
    command.args(&wanted.flight);
    if let Some(path) = &wanted.csv {
        command.arg("--csv").arg(path);
    }
    let status = stages::attached(&mut command)?;
    Ok(if status.success() { Outcome::Good } else { Outcome::Bad })
}
