//! `cargo xtask test`: the tools first, then the stages, cheapest first.
//!
//! Invariants:
//! - nothing runs before every tool that the run needs is there;
//! - the tests come last and write to the terminal themselves, and nothing is printed after them when they pass, so
//!   that the run ends with the test runner's own summary;
//! - the tests are told which legs to run through `BESSEMER_LEGS`, never by guessing from what is installed.
//!
//! What it must not know: what the tests test.

use crate::args::{Mode, Test};
use crate::error::{Error, Outcome};
use crate::install::Plan;
use crate::stages::{self, Progress};
use crate::tools::{self, Machine, Need, Tool};
use crate::{generate, project};
use std::path::Path;
use std::process::{Command, ExitStatus};

/// Runs everything that must pass.
///
/// # Errors
/// The first thing that is missing or fails.
pub fn run(root: &Path, wanted: &Test, machine: &dyn Machine) -> Result<Outcome, Error> {
    let mut progress = Progress::default();
    prepare(wanted, machine, &mut progress)?;
    if wanted.host {
        anstream::eprintln!(
            "--host: the ARM part is left out; nothing runs on the emulated Cortex-A9"
        );
    }
    let cargo = |arguments: &[&str]| {
        let mut command = project::cargo(root, arguments);
        command.env("BESSEMER_LEGS", legs(wanted));
        command
    };

    check(&mut progress, "format", cargo(&["fmt", "--all", "--check"]), Some("cargo fmt --all"))?;
    let lints = cargo(&["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"]);
    check(&mut progress, "lints", lints, None)?;
    progress.open("gen --check", || generate::run(root, Mode::Check, false))?;
    show(&mut progress, "documentation tests", cargo(&["test", "--workspace", "--doc"]))?;
    // Features of a package alone: in a workspace build they would reach the models of every test. Its builders run once.
    let witness = ["test", "--package", "bessemer", "--features", "generate", "--test", "witness"];
    let mut witness = cargo(&witness);
    witness.args(["--config", "profile.dev.package.bessemer.opt-level=0"]);
    show(&mut progress, "witness tests", witness)?;
    anstream::eprintln!("passed: {}; now the tests", progress.summary());
    attach("tests", cargo(&["test", "--workspace", "--lib", "--bins", "--examples", "--tests"]))?;
    Ok(Outcome::Good)
}

/// Sees to it that every tool is there, or says what to do.
///
/// # Errors
/// [`Error::Missing`] without `--install`; with it, what went wrong while installing.
pub fn prepare(wanted: &Test, machine: &dyn Machine, progress: &mut Progress) -> Result<(), Error> {
    let missing = lacking(wanted, machine);
    if missing.is_empty() {
        return Ok(());
    }
    let plan = Plan::of(&missing, machine);
    let Some(plan) = plan.as_ref().filter(|_| wanted.install) else {
        return Err(Error::Missing { tools: names(&missing), line: plan.map(|plan| plan.line()) });
    };
    plan.carry_out(&missing, progress)?;
    let left = lacking(wanted, machine);
    if left.is_empty() { Ok(()) } else { Err(Error::StillMissing { tools: names(&left) }) }
}

fn lacking(wanted: &Test, machine: &dyn Machine) -> Vec<&'static Tool> {
    let needs: &[Need] = match wanted.host {
        true => &[Need::Everything, Need::Host],
        false => &[Need::Everything, Need::Host, Need::Target],
    };
    tools::missing(&tools::survey(machine), needs)
}

fn names(tools: &[&'static Tool]) -> Vec<&'static str> {
    tools.iter().map(|tool| tool.name).collect()
}

/// What the tests read from `BESSEMER_LEGS`.
fn legs(wanted: &Test) -> &'static str {
    if wanted.host { "host" } else { "all" }
}

/// A stage that says nothing unless it fails.
fn check(
    progress: &mut Progress,
    stage: &'static str,
    mut command: Command,
    remedy: Option<&'static str>,
) -> Result<(), Error> {
    progress.closed(stage, |voice| verdict(stage, stages::captured(&mut command, voice)?, remedy))
}

/// A stage that shows its own output.
fn show(progress: &mut Progress, stage: &'static str, command: Command) -> Result<(), Error> {
    progress.open(stage, || attach(stage, command))
}

fn attach(stage: &'static str, mut command: Command) -> Result<(), Error> {
    verdict(stage, stages::attached(&mut command)?, None)
}

fn verdict(
    stage: &'static str,
    status: ExitStatus,
    remedy: Option<&'static str>,
) -> Result<(), Error> {
    if status.success() { Ok(()) } else { Err(Error::Stage { stage, status, remedy }) }
}
