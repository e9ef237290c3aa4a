//! `cargo xtask sim`, `identify`, `campaign`, `fly` and `replay`: run the programs of `sim/program` and `ground`.
//!
//! Invariant: these are separate programs, so that an error in a model never prevents building xtask, and they are
//! optimised, so that a flight is fast. The command lines are in `sim-args` and `ground-args`, so that help and
//! reports of mistakes need no build.
//!
//! What it must not know: the plant, the flights' contents, the page.

use crate::error::{Error, Outcome};
use crate::stages::Progress;
use crate::{project, stages};
use std::ffi::OsString;
use std::io::IsTerminal;
use std::path::Path;
use std::process::{Command, ExitStatus};

/// Builds the program of a package with these features, showing progress, and runs it with the command line's
/// arguments, already parsed.
///
/// # Errors
/// [`Error::Spawn`] if cargo does not start, [`Error::Stage`] if the program does not build.
pub fn run(
    root: &Path,
    package: &str,
    features: &[&str],
    words: impl Iterator<Item = OsString>,
) -> Result<Outcome, Error> {
    let stage = match package {
        "sim-program" => "building the simulation",
        _ => "building the ground station",
    };
    let features = features.join(",");
    let program = ["--release", "--package", package, "--features", &features];
    let mut build = project::cargo(root, &["build"]);
    build.args(program);
    let verdict = |status: ExitStatus| match status.success() {
        true => Ok(()),
        false => Err(Error::Stage { stage, status, remedy: None }),
    };
    // On a terminal cargo shows how far it is.
    match std::io::stderr().is_terminal() {
        true => verdict(stages::attached(&mut build)?)?,
        false => Progress::default()
            .closed(stage, |voice| verdict(stages::captured(&mut build, voice)?))?,
    }
    let mut command = project::cargo(root, &["run", "--quiet"]);
    command.args(program).arg("--").args(words);
    replaced_by(command)
}

/// Replaces this process by the program, which then receives the signals and sets the exit code.
#[cfg(unix)]
fn replaced_by(mut command: Command) -> Result<Outcome, Error> {
    let source = std::os::unix::process::CommandExt::exec(&mut command);
    Err(stages::spawn_error(&command, source))
}

/// Runs the program and waits for it, on systems without `exec`.
#[cfg(not(unix))]
fn replaced_by(mut command: Command) -> Result<Outcome, Error> {
    let status = stages::attached(&mut command)?;
    Ok(if status.success() { Outcome::Good } else { Outcome::Bad })
}
