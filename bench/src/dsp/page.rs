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
    Without contraction the PID step loads six numbers, has six operations and stores three numbers; the transforms have one constant \
    and\nnine operations. Fewer instructions take fused multiply-adds, whose bits are others than the Rust's, or `VMLA`, which rounds \
    twice as the\nRust does: `-mtune=cortex-a9` uses it. gcc does not for a Cortex-M4, where it takes three cycles, and a product and a \
    sum take two.\nCMSIS-DSP's transforms have two constants and take one instruction more, with the same flags.\n\n\
    The current loop has the transforms both ways and two PID steps. Its goal is 0.9 of CMSIS-DSP's count, whose sines are \
    interpolated\nin a table.\n\n\
    All sines are of 0.7 rad. In other quadrants the exact sine takes up to seven instructions more on the Cortex-M4F, sine and cosine \
    together up\nto three.\n";

/// Explains the text of the predictive control.
const TEXT: &str = "\n## Text of the predictive control\n\n\
    Bytes of `mpc_step` with its private functions for the Cortex-A9, and of its three products. The budget is `kernels.code_bytes`; below 1024,\n\
    `BESSEMER_FEW_PASSES` is in front of no loop. The goal for the step is 3,500 bytes.\n\n\
    | budget | step | kernels | instructions |\n|--:|--:|--:|--:|\n";

/// Explains why the text and the count have one goal each.
const CHOICE: &str = "\nThe passes over the states in `project` are a loop that stores and one that chooses the largest magnitudes: gcc computes four numbers \
    at once on the\nhost where a loop only stores. In one loop they took 195,715 instructions and 3,278 bytes, and on the host 1.00 of Eigen's time. gcc writes out a \
    loop of at most\ntwelve passes and forty operations in all, so this one and the two of the costs stay loops. Written out, they took 188,780 instructions and \
    5,854 bytes.\nBefore the loops were joined, the step took 194,514 instructions and 5,848 bytes.\n";

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
    text += TEXT;
    for row in json["predictive control, text"].as_array().into_iter().flatten() {
        let cell = |key: &str| row[key].as_u64().map_or("–".to_owned(), grouped);
        let cells = ["code_bytes", "step", "kernels", "instructions"].map(cell);
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
    text += CHOICE;
    text += &on_the_host(&json["predictive control, host"]);
    text += "\n## Versions\n\n";
    for (name, version) in json["versions"].as_object().into_iter().flatten() {
        let _ = writeln!(text, "* {name}: {}", version.as_str().unwrap_or_default());
    }
    text
}

/// Returns the section about the host.
fn on_the_host(json: &Value) -> String {
    let number = |value: &Value, places: usize| {
        value.as_f64().map_or("–".to_owned(), |value| format!("{value:.places$}"))
    };
    let (ours, eigen) = (number(&json["emitted C, µs"], 1), number(&json["Eigen, µs"], 1));
    let quartiles = ["lower quartile", "median", "upper quartile"];
    let [low, median, high] = quartiles.map(|key| number(&json["ratio"][key], 2));
    format!(
        "\n## Predictive control on the host\n\n\
         A step by gcc `-O2` on a processor with SSE2 takes {ours} µs, and with Eigen {eigen} µs, as they alternate in one program: {median} of Eigen's time (median;\n\
         quartiles {low} and {high}). The goal is 0.80. Two thirds of the emitted C's time are outside its kernels.\n"
    )
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
