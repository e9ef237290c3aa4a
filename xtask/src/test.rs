//! `cargo xtask test`: the tools first, then the stages, cheapest first; at the end what each took.
//!
//! Invariants:
//! - no test runs before every tool that the run needs is there; what is missing is installed beside the build;
//! - the tests come last, those of the documentation and the mutants beside them, which count as one test more each, and
//!   behind them the mutants whose tests need what these store; the summary of all is the last line of a run that got so far;
//! - of the tests that take longest, a run leaves out those of another turn, and prints how many;
//! - the tests are told what to run through the environment, never by guessing from what is installed:
//!   `BESSEMER_LEGS` names the machines, `BESSEMER_FULL` says that nothing may be left out, `BESSEMER_TURN` is the
//!   number by which a run that leaves something out takes turns.
//!
//! What it must not know: what the tests test.

use crate::args::{Gen, Test};
use crate::error::{Error, Outcome};
use crate::install::{Installation, Plan};
use crate::mutate::Share;
use crate::runner::{self, Done, Program, Spent, Times};
use crate::stages::{self, Progress};
use crate::tools::{self, Machine, Need, Tool};
use crate::{alternate, generate, mutate, project};
use serde_json::Value;
use std::collections::BTreeSet;
use std::num::NonZeroUsize;
use std::panic::resume_unwind;
use std::path::Path;
use std::process::{Command, ExitStatus};
use std::thread;
use std::time::{Duration, Instant};

/// File with the times of a stored run, which determine the order of tests, the selection of a quick run, and growth.
const TIMES: &str = "xtask/times.tsv";

/// Processor time above which a quick run omits a test.
const QUICK: Duration = Duration::from_secs(1);

/// Features of the ground station, each with a test of its name; they take long to build.
const TOOLS: &str = "foxglove,mavlink";

/// The stage in which the workspace is linted and built at once.
const BUILD: &str = "lints and build of the tests";

/// Name of the entry for the whole run among the stored times; it is processor time.
const ALL: &str = "processors in all";

/// Number of mutants that a run tries.
const MUTANTS: NonZeroUsize = NonZeroUsize::new(2).unwrap();

/// Number of slowest tests to list.
const SLOWEST: usize = 20;

/// Runs everything that must pass.
///
/// # Errors
/// The first thing that is missing or fails.
pub fn run(root: &Path, wanted: &Test, machine: &dyn Machine) -> Result<Outcome, Error> {
    let mut progress = Progress::default();
    let installation = prepare(wanted, machine, &mut progress)?;
    let installs = installation.is_some();
    if wanted.host {
        anstream::eprintln!(
            "--host: the ARM part is left out; nothing runs on the emulated Cortex-A9"
        );
    }
    let stored = std::fs::read_to_string(root.join(TIMES)).unwrap_or_default();
    let stored = Times::read(&stored);
    let environment = environment(root, wanted);
    let cargo = |arguments: &[&str]| project::cargo(root, arguments);

    check(&mut progress, "format", cargo(&["fmt", "--all", "--check"]), Some("cargo fmt --all"))?;
    progress.open("gen --check", || generate::run(root, &Gen::CHECK))?;
    if wanted.full {
        let lints = ["clippy", "--package", "ground", "--features", TOOLS, "--bins", "--tests"];
        let mut command = cargo(&lints);
        command.args(["--", "-D", "warnings"]);
        check(&mut progress, "lints of what only a full run builds", command, None)?;
    }
    let (programs, documented) = progress.closed(BUILD, |voice| programs(root, wanted, voice))?;
    if let Some(installation) = installation {
        installation.end(&mut progress)?;
        installed(wanted, machine)?;
    }
    let trials = (!wanted.quick).then(|| trials(root)).transpose()?;
    let turn = turn(root);
    let done = progress.closed("tests", |voice| {
        let chosen = |title: &str| match (wanted.full, wanted.quick) {
            (true, _) => true,
            (false, true) => stored.of(title) <= QUICK,
            (false, false) => alternate::is_due(title, turn),
        };
        thread::scope(|scope| {
            let mut beside = Vec::new();
            if let Some(trials) = &trials {
                beside.push(scope.spawn(move || mutants(trials, Share::WithoutTrees, voice)));
                beside.push(scope.spawn(|| documentation(root, &documented, voice)));
            }
            let mut done = runner::run(&programs, &chosen, &stored, &environment, voice)?;
            for one in beside {
                done.push(one.join().unwrap_or_else(|panic| resume_unwind(panic))?);
            }
            if let Some(trials) = &trials {
                done.push(mutants(trials, Share::WithTrees, voice)?);
            }
            Ok(done)
        })
    })?;
    let mut times = times(&progress, &done);
    if let Some(used) = runner::processors() {
        times.add(ALL, used);
    }
    if wanted.store_times {
        store(root, &times)?;
    }
    // A full run does more than the stored run did, and so does one that installs something.
    let grown = if wanted.full { Vec::new() } else { times.grown(&stored) };
    let alike = !(wanted.full || wanted.quick || installs);
    let whole = alike.then(|| times.grown_as_a_whole(&stored, ALL)).flatten();
    let left_out = if wanted.full || wanted.quick { 0 } else { alternate::left_out(turn) };
    report(&progress, &done, &grown, (times.of(ALL), whole), left_out);
    Ok(if done.iter().all(|test| test.passed) { Outcome::Good } else { Outcome::Bad })
}

/// Builds the tests of the workspace, those of generation builds, and in a full run those of the ground station's
/// tools. Also returns the packages whose documentation has examples.
fn programs(
    root: &Path,
    wanted: &Test,
    voice: &stages::Voice,
) -> Result<(Vec<Program>, BTreeSet<String>), Error> {
    let build = |arguments: &[&str], linted: bool| {
        let mut command = project::cargo(root, &["test", "--no-run", "--message-format", "json"]);
        command.args(arguments);
        if linted {
            project::lint(&mut command);
        }
        let (status, messages) = stages::answered(&mut command, voice)?;
        let said = said(&messages);
        said.iter().for_each(|said| voice.print(said));
        verdict(BUILD, status, None)?;
        // A warning is an error here, also one that cargo repeats from a build before.
        match said.len() {
            0 => Ok(messages),
            count => Err(Error::Lints { count }),
        }
    };
    let messages = build(&["--workspace", "--features", "unified/tests"], true)?;
    let (mut programs, documented) = (Program::of(&messages), documented(&messages));
    // Features of a package alone: in a workspace build they would reach the models of every test. With the settings of
    // a generation build, so that it is not built once more.
    const WITNESS: &str = "bessemer-witness";
    let settings: Vec<String> = bessemer_codegen::generate::settings(WITNESS).collect();
    let mut arguments = vec!["--package", WITNESS, "--features", "generate"];
    arguments.extend(settings.iter().flat_map(|setting| ["--config", setting]));
    programs.extend(Program::of(&build(&arguments, false)?));
    if wanted.full {
        for tool in TOOLS.split(',') {
            let package = ["--package", "ground", "--features", TOOLS, "--test", tool];
            programs.extend(Program::of(&build(&package, true)?));
        }
    }
    Ok((programs, documented))
}

/// Returns the packages of the workspace whose documentation has examples. The others say so in their manifests, so
/// that cargo does not search them.
fn documented(messages: &str) -> BTreeSet<String> {
    let messages = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let own = |message: &Value| {
        let package = message["package_id"].as_str().filter(|id| id.starts_with("path+"))?;
        (message["target"]["doctest"] == true).then(|| package.to_owned())
    };
    messages.filter_map(|message| own(&message)).collect()
}

/// Returns the messages of the compiler and its lints as text.
fn said(messages: &str) -> Vec<String> {
    let messages = messages.lines().filter_map(|line| serde_json::from_str::<Value>(line).ok());
    let said = messages.filter(|message| message["reason"] == "compiler-message");
    let said = said.filter_map(|message| Some(message["message"]["rendered"].as_str()?.to_owned()));
    let mut seen = BTreeSet::new();
    // A library is compiled again for its own tests, and tells the same again.
    said.filter(|said| seen.insert(said.clone())).collect()
}

/// Prepares the mutants that are due in this run.
fn trials(root: &Path) -> Result<mutate::Trials, Error> {
    mutate::Trials::of(root, &mutate::by_turn(root, turn(root), MUTANTS)?)
}

/// Tries the mutants of a share, and reports whether the tests detect them.
fn mutants(trials: &mutate::Trials, share: Share, voice: &stages::Voice) -> Result<Done, Error> {
    let start = Instant::now();
    let fates = trials.run(share, &Progress::silent(), &|line| voice.print(line))?;
    let passed = mutate::are_found(&fates);
    let title = match share {
        Share::WithTrees => "mutants that are found in trees",
        _ => "mutants that are found",
    };
    Ok(Done { title: title.to_owned(), passed, spent: Spent::since(start) })
}

/// Runs the examples of these packages' documentation, with the crates of the tests' build.
fn documentation(
    root: &Path,
    packages: &BTreeSet<String>,
    voice: &stages::Voice,
) -> Result<Done, Error> {
    let start = Instant::now();
    let mut command = project::cargo(root, &["test", "--doc"]);
    command.args(packages.iter().flat_map(|package| ["--package", package])).args(project::UNIFIED);
    let passed = stages::captured(project::lint(&mut command), voice)?.success();
    Ok(Done { title: "documentation tests".to_owned(), passed, spent: Spent::since(start) })
}

/// The times of the stages and tests of this run.
fn times(progress: &Progress, done: &[Done]) -> Times {
    let mut times = Times::default();
    let stages = progress.done().iter().map(|(name, time)| (name, time));
    let tests = done.iter().map(|test| (&test.title, &test.spent.work));
    stages.chain(tests).for_each(|(name, time)| times.add(name, *time));
    times
}

fn store(root: &Path, times: &Times) -> Result<(), Error> {
    let path = root.join(TIMES);
    std::fs::write(&path, times.text()).map_err(|source| Error::File { path, source })
}

/// Prints times, growth and failures, and then the summary.
fn report(
    progress: &Progress,
    done: &[Done],
    grown: &[(String, f64)],
    (processors, whole): (Duration, Option<f64>),
    left_out: usize,
) {
    anstream::println!("\nstages");
    for (name, time) in progress.done() {
        anstream::println!("{:>8.1} s  {name}", time.as_secs_f64());
    }
    anstream::println!("\nslowest tests: processor time, then time by the clock");
    for test in runner::slowest(done, SLOWEST) {
        let Spent { time, work } = test.spent;
        let (work, time) = (work.as_secs_f64(), time.as_secs_f64());
        anstream::println!("{work:>8.1} s {time:>6.1} s  {}", test.title);
    }
    anstream::println!("\n{:>8.1} s  {ALL}", processors.as_secs_f64());
    if let Some(ratio) = whole {
        anstream::println!("\ngrew to {ratio:.2} of what {TIMES} has: {ALL}");
    }
    for (name, ratio) in grown {
        anstream::println!("\ngrew to {ratio:.1} of its share in {TIMES}: {name}");
    }
    let failed: Vec<&Done> = done.iter().filter(|test| !test.passed).collect();
    for test in &failed {
        anstream::println!("\nfailed: {}", test.title);
    }
    if left_out > 0 {
        anstream::println!("\n{left_out} tests are those of another turn; `--full` runs all");
    }
    anstream::println!("\n{} passed, {} failed", done.len() - failed.len(), failed.len());
}

/// The environment that the tests read.
fn environment(root: &Path, wanted: &Test) -> Vec<(&'static str, String)> {
    let legs = if wanted.host { "host" } else { "all" };
    let mut list = vec![("BESSEMER_LEGS", legs.to_owned())];
    match wanted.full {
        true => list.push(("BESSEMER_FULL", "1".to_owned())),
        false => list.push(("BESSEMER_TURN", turn(root).to_string())),
    }
    list
}

/// Returns a number derived from the commit, so that commits alternate, and a commit is always tested in the same
/// way.
fn turn(root: &Path) -> u32 {
    let mut git = Command::new("git");
    let output = git.args(["rev-parse", "--short=7", "HEAD"]).current_dir(root).output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned());
    u32::from_str_radix(text.unwrap_or_default().trim(), 16).unwrap_or_default()
}

/// Ensures that every tool will be available when the tests begin, or describes the remedy. Returns the installation
/// that runs beside the build, if any.
///
/// # Errors
/// [`Error::Missing`] without `--install`; with it, what went wrong while installing.
pub fn prepare(
    wanted: &Test,
    machine: &dyn Machine,
    progress: &mut Progress,
) -> Result<Option<Installation>, Error> {
    let missing = lacking(wanted, machine);
    if missing.is_empty() {
        return Ok(None);
    }
    let plan = match Plan::of(&missing, machine) {
        Some(plan) if wanted.install => plan,
        plan => {
            let line = plan.map(|plan| plan.line());
            return Err(Error::Missing { tools: names(&missing), line });
        }
    };
    let installation = plan.start(&missing, progress)?;
    if installation.is_none() {
        installed(wanted, machine)?;
    }
    Ok(installation)
}

/// Checks that the installed tools work.
fn installed(wanted: &Test, machine: &dyn Machine) -> Result<(), Error> {
    let left = lacking(wanted, machine);
    if left.is_empty() { Ok(()) } else { Err(Error::StillMissing { tools: names(&left) }) }
}

fn lacking(wanted: &Test, machine: &dyn Machine) -> Vec<&'static Tool> {
    let mut needs = vec![Need::Everything, Need::Host];
    if !wanted.host {
        needs.extend([Need::Target, Need::Analysis]);
    }
    if wanted.full {
        needs.push(Need::Full);
    }
    tools::missing(&tools::survey(machine), &needs)
}

fn names(tools: &[&'static Tool]) -> Vec<&'static str> {
    tools.iter().map(|tool| tool.name).collect()
}

/// Runs a stage without output unless it fails.
fn check(
    progress: &mut Progress,
    stage: &'static str,
    mut command: Command,
    remedy: Option<&'static str>,
) -> Result<(), Error> {
    progress.closed(stage, |voice| verdict(stage, stages::captured(&mut command, voice)?, remedy))
}

fn verdict(
    stage: &'static str,
    status: ExitStatus,
    remedy: Option<&'static str>,
) -> Result<(), Error> {
    if status.success() { Ok(()) } else { Err(Error::Stage { stage, status, remedy }) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESSAGES: &str = r#"{"reason":"compiler-artifact","target":{"name":"all"}}
{"reason":"compiler-message","message":{"level":"warning","rendered":"warning: one\n"}}
not JSON
{"reason":"compiler-message","message":{"level":"warning","rendered":"warning: one\n"}}
{"reason":"compiler-message","message":{"level":"warning","rendered":"warning: two\n"}}"#;

    #[test]
    fn examples_are_those_of_packages_that_may_have_some() {
        let message = |id: &str, doctest| {
            let target = format!(r#"{{"name":"a","doctest":{doctest}}}"#);
            format!(r#"{{"reason":"compiler-artifact","package_id":"{id}","target":{target}}}"#)
        };
        let messages = [
            message("path+file:///a/dsl#bessemer@0.1.0", true),
            message("path+file:///a/sim#0.1.0", false),
            message("registry+https://index#syn@3.0.0", true),
        ];
        let documented = documented(&messages.join("\n"));
        assert!(documented.iter().eq(["path+file:///a/dsl#bessemer@0.1.0"]), "{documented:?}");
    }

    #[test]
    fn a_warning_is_told_once() {
        assert_eq!(said(MESSAGES), ["warning: one\n", "warning: two\n"]);
    }
}
