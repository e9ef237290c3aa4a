//! `cargo xtask bench` and `crates`: checks the tools, then runs the programs of the `bench` crate.
//!
//! What it must not know: what is measured.

use crate::args::{Bench, Crates};
use crate::error::{Error, Outcome};
use crate::install::Plan;
use crate::stages::Progress;
use crate::tools::{self, Machine, Need, Tool};
use crate::{project, stages};
use std::path::Path;

/// The tools that a part needs. The other parts need only Rust, or omit what is missing.
fn needs(only: Option<&str>) -> &'static [Need] {
    match only {
        None | Some("kernels") => &[Need::Everything, Need::Host, Need::Target, Need::Bench],
        Some("onboard" | "dsp" | "ekf" | "gradient" | "qp" | "equality" | "accuracy-points") => {
            &[Need::Everything, Need::Host, Need::Target]
        }
        Some("threads") => &[Need::Host],
        Some(_) => &[],
    }
}

/// Runs the measurements.
///
/// # Errors
/// [`Error::Missing`] without `--install`; with it, what went wrong while installing; [`Error::Spawn`] if cargo
/// does not start.
pub fn run(root: &Path, wanted: &Bench, machine: &dyn Machine) -> Result<Outcome, Error> {
    prepare(needs(wanted.only.as_deref()), wanted.install, machine)?;
    let mut command = project::cargo(root, &["run", "--quiet", "--package", "bench", "--"]);
    if wanted.quick {
        command.arg("--quick");
    }
    if wanted.counts {
        command.arg("--counts");
    }
    if let Some(only) = &wanted.only {
        command.args(["--only", only]);
    }
    if let Some(machines) = &wanted.machines {
        command.args(["--machines", machines]);
    }
    if let Some(sizes) = &wanted.sizes {
        command.args(["--sizes", sizes]);
    }
    if let Some(points) = wanted.points {
        command.args(["--points", &points.to_string()]);
    }
    if let Some(peers) = &wanted.peers {
        command.args(["--peers", peers]);
    }
    let status = stages::attached(&mut command)?;
    Ok(if status.success() { Outcome::Good } else { Outcome::Bad })
}

/// Tries the crates of the field.
///
/// # Errors
/// [`Error::Missing`] without gcc, [`Error::Spawn`] if cargo does not start.
pub fn crates(root: &Path, wanted: &Crates, machine: &dyn Machine) -> Result<Outcome, Error> {
    prepare(&[Need::Host], false, machine)?;
    let run = ["run", "--quiet", "--package", "bench", "--bin", "crates", "--"];
    let mut command = project::cargo(root, &run);
    command.args(&wanted.names);
    command.args(wanted.verbose.then_some("--verbose"));
    command.args(wanted.dry.then_some("--dry"));
    let status = stages::attached(&mut command)?;
    Ok(if status.success() { Outcome::Good } else { Outcome::Bad })
}

fn prepare(needs: &[Need], install: bool, machine: &dyn Machine) -> Result<(), Error> {
    let missing = lacking(machine, needs);
    if missing.is_empty() {
        return Ok(());
    }
    let plan = Plan::of(&missing, machine);
    let Some(plan) = plan.as_ref().filter(|_| install) else {
        return Err(Error::Missing { tools: names(&missing), line: plan.map(|plan| plan.line()) });
    };
    plan.carry_out(&missing, &mut Progress::default())?;
    let left = lacking(machine, needs);
    if left.is_empty() { Ok(()) } else { Err(Error::StillMissing { tools: names(&left) }) }
}

fn lacking(machine: &dyn Machine, needs: &[Need]) -> Vec<&'static Tool> {
    tools::missing(&tools::survey(machine), needs)
}

fn names(tools: &[&'static Tool]) -> Vec<&'static str> {
    tools.iter().map(|tool| tool.name).collect()
}
