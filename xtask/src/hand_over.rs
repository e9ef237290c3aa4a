//! `cargo xtask sim`, `identify`, `campaign`, `fly` and `replay`: run the programs of `sim/program` and `ground`.
//!
//! Invariant: these are separate programs, so that an error in a model never prevents building xtask. Simulations are
//! optimised as a whole, so that a campaign is fast; the ground station flies in real time and is built like the tests,
//! with the crates that xtask has already. The command lines are in `sim-args` and `ground-args`, so that help and
//! reports of mistakes need no build.
//!
//! What it must not know: the plant, the flights' contents, the page.

use crate::error::{Error, Outcome};
use crate::project::{self, UNIFIED};
use crate::stages;
use crate::stages::Progress;
use serde_json::Value;
use std::ffi::OsString;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A program that is built before it runs.
#[derive(Clone, Copy, Debug)]
pub struct Handed {
    /// Its package.
    package: &'static str,
    /// Arguments of cargo that select how it is built.
    build: &'static [&'static str],
    /// Description of the build for a reader who waits.
    stage: &'static str,
}

/// Simulated flights, identification and campaigns.
pub const SIMULATION: Handed = Handed {
    package: "sim-program",
    build: &["--profile", "fast"],
    stage: "building the simulation",
};

/// The ground station and the testbed. With the features of [`UNIFIED`], no crate of xtask is built again for it.
pub const GROUND: Handed =
    Handed { package: "ground", build: &UNIFIED, stage: "building the ground station" };

/// Builds a program with these features, showing progress, and runs it with the command line's arguments, already
/// parsed.
///
/// # Errors
/// [`Error::Spawn`] if cargo does not start, [`Error::Stage`] if the program does not build.
pub fn run(
    root: &Path,
    handed: &Handed,
    features: &[&str],
    words: impl Iterator<Item = OsString>,
) -> Result<Outcome, Error> {
    let mut build = project::cargo(root, &["build", "--package", handed.package]);
    build.args(handed.build).args(["--message-format", "json-render-diagnostics"]);
    if !features.is_empty() {
        let of = |feature: &&str| format!("{}/{feature}", handed.package);
        build.args(["--features", &features.iter().map(of).collect::<Vec<_>>().join(",")]);
    }
    // On a terminal cargo shows how far it is.
    let (status, messages) = match std::io::stderr().is_terminal() {
        true => stages::answered_beside(&mut build)?,
        false => {
            Progress::default().closed(handed.stage, |voice| stages::answered(&mut build, voice))?
        }
    };
    let failed = Error::Stage { stage: handed.stage, status, remedy: None };
    let program = program(&messages).filter(|_| status.success()).ok_or(failed)?;
    let mut command = Command::new(program);
    command.args(words).current_dir(root);
    replaced_by(command)
}

/// Returns the path of the program that cargo's messages name.
fn program(messages: &str) -> Option<PathBuf> {
    let messages = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    messages.filter_map(|message| Some(message["executable"].as_str()?.into())).next_back()
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_program_is_the_last_that_cargo_names() {
        let messages = r#"{"reason":"compiler-artifact","executable":null}
            {"reason":"compiler-artifact","executable":"/target/debug/ground"}
            {"reason":"build-finished","success":true}"#;
        assert_eq!(program(messages), Some("/target/debug/ground".into()));
        assert_eq!(program(""), None);
    }
}
