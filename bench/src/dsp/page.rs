//! The page of the results, `bench/results/dsp.md`, and the table for a terminal.

use std::fmt::Write as _;

use serde_json::Value;

use super::jobs::{JOBS, Machine};

/// The columns of a machine.
fn columns(machine: Machine) -> &'static [&'static str] {
    match machine {
        Machine::M4f => &["emitted C", "CMSIS-DSP", "CMSIS-DSP, unrolled"],
        Machine::A9 => &["emitted C", "Eigen, fixed sizes", "TinyMPC"],
    }
}

/// Reasons for the counts of the short jobs, from their assembly.
const NOTES: &str = "\n## Short jobs\n\n\
    A count has the call and its arguments, which are more than a third of a short function's. So PID step and transforms are measured \
    twice:\ncalled as a function of a library, neither inlined nor specialised for the constants of the call, and inlined in a caller \
    that has every\nargument in a register. A function that its author marks `#[inline]` is in `bessemer_inline.h`, from which firmware \
    inlines it; CMSIS-DSP's\nare in its headers. Both counts have the call of the mark behind the job.\n\n\
    Without contraction the PID step loads six numbers, has six operations and stores three numbers; the transforms have two constants \
    and\nnine operations. Fewer instructions take fused multiply-adds, whose bits are others than the Rust's, or `VMLA`, which rounds \
    twice as the\nRust does: `-mtune=cortex-a9` uses it. gcc does not for a Cortex-M4, where it takes three cycles, and a product and a \
    sum take two.\n";

/// Returns the page of a result file.
pub fn markdown(json: &Value) -> String {
    let mut text = String::from(
        "# Blocks, filters and predictive control beside libraries\n\n\
         Executed instructions in single precision, by gcc `-O2` without contraction, counted under QEMU. The emitted C comes from\n\
         [bench/dsp/controllers.rs](../dsp/controllers.rs), written as a user writes it; results are compared before counts. Instructions are no\n\
         cycles: there is no cache and no pipeline. `cargo xtask bench --only dsp --peers FOLDER` measures them again, with `CMSIS-DSP` and\n\
         `TinyMPC` in that folder, and writes [dsp.json](dsp.json) and this page.\n",
    );
    for (title, machine) in [("Cortex-M4F", Machine::M4f), ("Cortex-A9 without NEON", Machine::A9)]
    {
        let columns = columns(machine);
        let _ = write!(
            text,
            "\n## {title}\n\n| job | {} | goal | reached |\n|---|",
            columns.join(" | ")
        );
        text += &"--:|".repeat(columns.len() + 2);
        text.push('\n');
        for job in JOBS.iter().filter(|job| job.machine == machine) {
            let counts = counts(json, job.name);
            let cell = |name: &&str| counts[*name].as_u64().map_or("–".to_owned(), grouped);
            let cells: Vec<String> = columns.iter().map(cell).collect();
            let ours = counts["emitted C"].as_u64().unwrap_or(u64::MAX);
            let reached = if ours <= job.goal { "yes" } else { "no" };
            let (cells, goal) = (cells.join(" | "), grouped(job.goal));
            let _ = writeln!(text, "| {} | {cells} | {goal} | {reached} |", job.name);
        }
    }
    text += NOTES;
    text += "\n## Versions\n\n";
    for (name, version) in json["versions"].as_object().into_iter().flatten() {
        let _ = writeln!(text, "* {name}: {}", version.as_str().unwrap_or_default());
    }
    text
}

/// Returns the counts of a job in a result file.
fn counts<'j>(json: &'j Value, name: &str) -> &'j Value {
    let jobs = json["jobs"].as_array().into_iter().flatten();
    let of = |job: &&Value| job["job"].as_str() == Some(name);
    jobs.into_iter().find(of).map_or(&Value::Null, |job| &job["instructions"])
}

/// Returns a number with commas.
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
