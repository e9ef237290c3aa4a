//! Measures blocks, filters and model predictive control against the libraries that microcontroller teams use.
//!
//! It counts executed instructions in single precision, by gcc `-O2`, exactly under QEMU.
//!
//! The emitted C comes from `bench/dsp/controllers.rs`, written as a user writes it. Each contender runs the same
//! inputs (`bench/c/dsp_*`), and its results are compared before its counts are. CMSIS-DSP and TinyMPC, with its
//! Eigen, are in a folder that the caller names; without it the emitted C is measured alone.

pub mod jobs;
mod mpc;
pub mod page;
mod program;

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use bessemer_tests::toolchain;
use serde_json::{Value, json};

use jobs::{JOBS, Job, Machine};
use mpc::{Host, Text};
pub use program::first_line;
use program::{CONTENDERS, Contender, Run};

/// Largest difference of a contender's result, relative to the largest number of that result.
const TOLERANCE: f32 = 2e-4;

/// The counts of one job.
#[derive(Clone, Debug)]
pub struct Row {
    /// The job.
    pub job: &'static Job,
    /// Instructions of each contender that has the job.
    pub counts: BTreeMap<&'static str, u64>,
    /// Estimate of the longest path of the emitted C; none if a loop has no known number of passes.
    pub estimate: Option<u64>,
}

/// The measurement.
#[derive(Clone, Debug)]
pub struct Found {
    /// The rows, in the order of [`JOBS`].
    pub rows: Vec<Row>,
    /// Text of the predictive control, by the budget of code.
    pub texts: Vec<Text>,
    /// Times of the predictive control on the host; none without the peers.
    pub host: Option<Host>,
    /// The libraries with their versions.
    pub peers: BTreeMap<&'static str, String>,
}

/// Measures every job; `peers` is the folder with `CMSIS-DSP` and `TinyMPC`.
///
/// # Errors
/// The message of a tool, or that a contender's results differ.
pub fn measure(peers: Option<&Path>) -> Result<Found, String> {
    let folder = bessemer_tests::root().join("target/bench/dsp");
    std::fs::create_dir_all(&folder).map_err(|error| error.to_string())?;
    let compiled = program::compiled()?;
    let emitted = program::written(&compiled, &folder)?;
    let estimates = program::estimates(&compiled);
    let row = |job: &'static Job| {
        let estimate = estimates.get(job.function).copied().flatten();
        Row { job, counts: BTreeMap::new(), estimate }
    };
    let mut rows: Vec<Row> = JOBS.iter().map(row).collect();
    let mut references: BTreeMap<Machine, Run> = BTreeMap::new();
    for contender in CONTENDERS.iter().filter(|it| it.peer.is_none() || peers.is_some()) {
        let run = program::run(contender, &folder, &emitted, peers)?;
        if let Some(reference) = references.get(&contender.machine) {
            compare(contender, &run, reference)?;
        }
        let jobs = rows.iter_mut().filter(|row| row.job.machine == contender.machine);
        for (row, calls) in jobs.zip(&run.counts) {
            // The last call, whose state is no longer the initial one.
            row.counts.extend(calls.last().map(|count| (contender.name, *count)));
        }
        references.entry(contender.machine).or_insert(run);
    }
    let mut versions = BTreeMap::new();
    for name in peers.map_or(&[][..], |_| &["CMSIS-DSP", "TinyMPC"]) {
        let folder = peers.map(|peers| peers.join(name)).unwrap_or_default();
        versions.insert(*name, version(&folder)?);
    }
    let texts = mpc::texts(&compiled, &folder)?;
    let host = peers.map(|peers| mpc::host(&emitted, &folder, peers)).transpose()?;
    Ok(Found { rows, texts, host, peers: versions })
}

/// Returns the version of a library by its repository.
fn version(folder: &Path) -> Result<String, String> {
    let mut command = Command::new("git");
    command.arg("-C").arg(folder).args(["describe", "--tags", "--always"]);
    let output = command.output().map_err(|error| format!("git: {error}"))?;
    match output.status.success() {
        true => Ok(String::from_utf8_lossy(&output.stdout).trim().to_owned()),
        false => Err(format!("`{}` is no repository with a version", folder.display())),
    }
}

/// Compares the results of two contenders, job by job.
fn compare(contender: &Contender, run: &Run, reference: &Run) -> Result<(), String> {
    let jobs = JOBS.iter().filter(|job| job.machine == contender.machine);
    for ((job, ours), theirs) in jobs.zip(&reference.results).zip(&run.results) {
        let largest = ours.iter().fold(0.0_f32, |most, x| most.max(x.abs()));
        let near = |(x, y): (&f32, &f32)| (x - y).abs() <= TOLERANCE * largest;
        if ours.len() != theirs.len() || !ours.iter().zip(theirs).all(near) {
            return Err(format!("{}: {} has other results", job.name, contender.name));
        }
    }
    Ok(())
}

/// Formats the rows for machines.
pub fn json(found: &Found) -> Value {
    let row = |row: &Row| json!({ "job": row.job.name, "instructions": row.counts, "estimate": row.estimate });
    let mut versions = found.peers.clone();
    let programs = [
        ("arm-none-eabi-gcc", "Cortex-M4F"),
        ("arm-linux-gnueabihf-gcc", "Cortex-A9"),
        ("gcc", "host"),
    ];
    for (name, program) in programs {
        versions.extend(first_line(name).map(|line| (program, line)));
    }
    json!({
        "command": "cargo xtask bench --only dsp --peers FOLDER",
        "flags": "-O2 -ffp-contract=off",
        "Cortex-M4F flags": toolchain::CORTEX_M4F.machine.join(" "),
        "Cortex-A9 flags": toolchain::CORTEX_A9.join(" "),
        "versions": versions,
        "jobs": found.rows.iter().map(row).collect::<Vec<_>>(),
        "predictive control, text": mpc::texts_json(&found.texts),
        "predictive control, host": mpc::host_json(found.host.as_ref()),
    })
}
