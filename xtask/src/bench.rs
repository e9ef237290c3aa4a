//! `cargo xtask bench`: hands over to the program of the `bench` crate.
//!
//! What it must not know: what is measured.

use crate::args::Bench;
use crate::error::{Error, Outcome};
use crate::{project, stages};
use std::path::Path;

/// Runs the measurements that there are.
///
/// # Errors
/// [`Error::Spawn`] if cargo does not start.
pub fn run(root: &Path, wanted: &Bench) -> Result<Outcome, Error> {
    let mut command = project::cargo(root, &["run", "--quiet", "--package", "bench", "--"]);
    if wanted.quick {
        command.arg("--quick");
    }
    let status = stages::attached(&mut command)?;
    Ok(if status.success() { Outcome::Good } else { Outcome::Bad })
}
