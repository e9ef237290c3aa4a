//! `cargo xtask fuzz`: builds the tests across the crates, and lets them run as many random programs as requested.
//!
//! What it must not know: what a program is, and what is compared.

use crate::args::Fuzz;
use crate::error::{Error, Outcome};
use crate::project;
use crate::runner::Program;
use crate::stages::{self, Progress};
use std::path::Path;

/// The test that runs a requested number of programs.
const TEST: &str = "random::fuzz::as_many_as_asked";

/// Crates that are optimised, since they run for hours: the compiler, and those that read trees and compare words.
const OPTIMISED: [&str; 11] = [
    "bessemer-backend",
    "bessemer-codegen",
    "bessemer-derivative",
    "bessemer-frontend",
    "bessemer-ir",
    "bessemer-legs",
    "bessemer-tests",
    "bessemer-tree",
    "bessemer-words",
    "serde_core",
    "serde_json",
];

/// Runs the programs.
///
/// # Errors
/// [`Error::Spawn`] if something does not start, [`Error::Stage`] if the tests do not build.
pub fn run(root: &Path, wanted: &Fuzz) -> Result<Outcome, Error> {
    let stage = "build of the tests";
    let build = ["test", "--no-run", "--message-format", "json-render-diagnostics"];
    let mut build = project::cargo(root, &build);
    build.args(["--package", "bessemer-tests", "--test", "all"]);
    for package in OPTIMISED {
        build.args(["--config", &format!("profile.dev.package.{package}.opt-level=2")]);
    }
    let (status, messages) =
        Progress::default().closed(stage, |voice| stages::answered(&mut build, voice))?;
    let programs = Program::of(&messages);
    let (true, Some(program)) = (status.success(), programs.first()) else {
        return Err(Error::Stage { stage, status, remedy: None });
    };
    let environment = [
        ("BESSEMER_LEGS", "host".to_owned()),
        ("BESSEMER_FUZZ", wanted.programs.to_string()),
        ("BESSEMER_RANDOM_FROM", wanted.seed.to_string()),
    ];
    let mut command = program.command(&environment);
    command.args([TEST, "--exact", "--ignored", "--nocapture"]);
    let status = stages::attached(&mut command)?;
    Ok(if status.success() { Outcome::Good } else { Outcome::Bad })
}
