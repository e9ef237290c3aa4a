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
    sum take two.\nCMSIS-DSP's transforms take as many, with the same flags.\n\
    \n## Text of the predictive control\n\n\
    `mpc_step` has 5,848 bytes for the Cortex-A9, beside kernels of 1,472 bytes. Almost half are passes of loops over twelve states that\n\
    `BESSEMER_FEW_PASSES` has gcc write out. Without it the step has 3,114 bytes, and takes 221,793 instructions instead of 194,514;\n\
    `kernels.code_bytes` below 1024 leaves it out. Five loops over the states follow each other in `project`. As one loop in the C, they give\n\
    4,356 bytes and 190,264 instructions, or 2,960 bytes and 202,915 instructions without the macro. The generator does not join loops.\n";

/// Returns the page of a result file.
pub fn markdown(json: &Value) -> String {
    let mut text = String::from(
        "# Blocks, filters and predictive control beside libraries\n\n\
         Executed instructions in single precision, by gcc `-O2` without contraction, counted under QEMU. The emitted C comes from\n\
         [bench/dsp/controllers.rs](../dsp/controllers.rs), written as a user writes it; results are compared before counts. Instructions are no\n\
         cycles: there is no cache and no pipeline. `cargo xtask bench --only dsp --peers FOLDER` measures them again, with `CMSIS-DSP` and\n\
         `TinyMPC` in that folder, and writes [dsp.json](dsp.json) and this page. The estimate is the one of `cargo bessemer sizes`: instructions\n\
         on the longest path, by weights of operations that are no processor's. It is never below the count.\n",
    );
    for (title, machine) in [("Cortex-M4F", Machine::M4f), ("Cortex-A9 without NEON", Machine::A9)]
    {
        let columns = columns(machine);
        let _ = write!(
            text,
            "\n## {title}\n\n| job | {} | goal | reached | estimate |\n|---|",
            columns.join(" | ")
        );
        text += &"--:|".repeat(columns.len() + 3);
        text.push('\n');
        for job in JOBS.iter().filter(|job| job.machine == machine) {
            let found = found(json, job.name);
            let counts = &found["instructions"];
            let cell = |name: &&str| counts[*name].as_u64().map_or("–".to_owned(), grouped);
            let cells: Vec<String> = columns.iter().map(cell).collect();
            let ours = counts["emitted C"].as_u64().unwrap_or(u64::MAX);
            let reached = if ours <= job.goal { "yes" } else { "no" };
            let (cells, goal) = (cells.join(" | "), grouped(job.goal));
            let estimate = found["estimate"].as_u64().map_or("–".to_owned(), grouped);
            let _ = writeln!(text, "| {} | {cells} | {goal} | {reached} | {estimate} |", job.name);
        }
    }
    text += NOTES;
    text += "\n## Versions\n\n";
    for (name, version) in json["versions"].as_object().into_iter().flatten() {
        let _ = writeln!(text, "* {name}: {}", version.as_str().unwrap_or_default());
    }
    text
}

/// Returns a job of a result file.
fn found<'j>(json: &'j Value, name: &str) -> &'j Value {
    let jobs = json["jobs"].as_array().into_iter().flatten();
    let of = |job: &&Value| job["job"].as_str() == Some(name);
    jobs.into_iter().find(of).unwrap_or(&Value::Null)
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
