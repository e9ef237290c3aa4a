//! Cost of generating one long function, by its number of operations. rustc's part must grow linearly, not
//! quadratically.
//!
//! The whole of `cargo xtask gen` is measured: cargo, rustc, the linker and the C; dependencies are built before.
//! Every line of the function changes in each run, so that rustc's incremental data is of little use. The result is
//! processor time, and the largest memory of the generator.

use std::fmt::Write as _;
use std::fs;

use bessemer_codegen::generate::{self, Job};
use bessemer_tests::workspace::Workspace;
use serde_json::{Value, json};

use crate::check_cost::{all_seconds, hundredths, spread};

/// Numbers of operations of the function: additions, products, comparisons, choices, `clamp`.
pub const SIZES: [usize; 5] = [500, 1000, 2000, 4000, 8000];

/// Measurements of a function.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// Number of operations.
    pub operations: usize,
    /// Processor seconds: smallest, median, largest.
    pub seconds: [f64; 3],
    /// Largest memory of the generator, MB, without cargo and rustc; none where the system does not report it.
    pub megabytes: Option<u64>,
}

/// The measured times.
#[derive(Clone, Debug)]
pub struct Long {
    /// Number of generations for each size.
    pub runs: usize,
    /// One for each size.
    pub rows: Vec<Row>,
}

impl Long {
    /// Formats the result for machines.
    pub fn json(&self) -> Value {
        let row = |row: &Row| {
            json!({
                "operations": row.operations,
                "seconds": row.seconds.map(hundredths),
                "megabytes": row.megabytes,
            })
        };
        json!({
            "command": "cargo xtask bench --only long",
            "runs": self.runs,
            "functions": self.rows.iter().map(row).collect::<Vec<_>>(),
        })
    }

    /// Formats the result for people.
    pub fn table(&self) -> String {
        let mut text = format!(
            "generation of one function, processor seconds, {} runs each\n\n{:>10} {:>8} {:>8} {:>8} {:>6}\n",
            self.runs, "operations", "smallest", "median", "largest", "MB"
        );
        for Row { operations, seconds: [low, median, high], megabytes } in &self.rows {
            let memory = megabytes.map_or("–".to_owned(), |it| it.to_string());
            let _ =
                writeln!(text, "{operations:>10} {low:>8.2} {median:>8.2} {high:>8.2} {memory:>6}");
        }
        text
    }
}

/// Measures all sizes; calls `tick` after each generation.
///
/// # Errors
/// The message of cargo, the generator or the file system.
pub fn measure(runs: usize, mut tick: impl FnMut()) -> Result<Long, String> {
    let mut rows = Vec::new();
    for operations in SIZES {
        let failed = |error: std::io::Error| error.to_string();
        let workspace = Workspace::with_source(&source(operations, 0)).map_err(failed)?;
        let job = Job::new(workspace.path(""), "models");
        // Builds what the package depends on.
        generate::generate(&job).map_err(|error| error.to_string())?;
        let mut times = Vec::new();
        forget_peak();
        for run in 1..=runs {
            workspace.set_source(&source(operations, run)).map_err(failed)?;
            let before = all_seconds()?;
            generate::generate(&job).map_err(|error| error.to_string())?;
            times.push(all_seconds()? - before);
            tick();
        }
        fs::remove_dir_all(&job.output).map_err(failed)?;
        rows.push(Row { operations, seconds: spread(times), megabytes: peak() });
    }
    Ok(Long { runs, rows })
}

/// Resets the largest memory that Linux reports; elsewhere it stays unknown.
fn forget_peak() {
    let _ = fs::write("/proc/self/clear_refs", "5");
}

/// Returns the largest memory of this process in MB since it was reset.
fn peak() -> Option<u64> {
    let text = fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find(|line| line.starts_with("VmHWM:"))?;
    let kilobytes: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(kilobytes / 1000)
}

/// Generates a function with some number of operations, ten in four lines, similar to a controller.
fn source(operations: usize, run: usize) -> String {
    let mut text =
        "//! A long function.\n#![no_std]\nuse bessemer::prelude::*;\n\n/// Long.\n#[function]\n\
        pub fn long(a: f64, b: f64, r: f64) -> f64 {\n    let x0 = a;\n    let x1 = b;\n"
            .to_owned();
    for n in 2..2 + operations / 10 {
        let (one, two) = (n - 1, n - 2);
        let _ = write!(
            text,
            "    let e{n} = r - x{one};\n    let p{n} = e{n} * {run}.5 + x{two} * a;\n    \
             let q{n} = if p{n} > b {{ p{n} - {run}.25 }} else {{ p{n} + {run}.75 }};\n    \
             let x{n} = q{n}.clamp(-1.0, 1.0) * {run}.125 - e{n};\n"
        );
    }
    let _ = write!(text, "    x{}\n}}\n", 1 + operations / 10);
    text
}
