//! Cost of generating one long function, by its number of operations. rustc's part must grow linearly, not
//! quadratically.
//!
//! The whole of `cargo xtask gen` is measured: cargo, rustc, the linker and the C; dependencies are built before.
//! Every line of the function changes in each run, so that rustc's incremental data is of little use. The result is
//! processor time.

use std::fmt::Write as _;
use std::fs;

use bessemer_codegen::generate::{self, Job};
use bessemer_tests::workspace::Workspace;
use serde_json::{Value, json};

use crate::check_cost::{all_seconds, hundredths, spread};

/// Numbers of operations of the function: additions, products, comparisons, choices, `clamp`.
const SIZES: [usize; 3] = [500, 1000, 2000];

/// The measured times.
#[derive(Clone, Debug)]
pub struct Long {
    /// Number of generations for each size.
    pub runs: usize,
    /// Operations, and processor seconds: smallest, median, largest.
    pub rows: Vec<(usize, [f64; 3])>,
}

impl Long {
    /// Formats the result for machines.
    pub fn json(&self) -> Value {
        let row = |(operations, seconds): &(usize, [f64; 3])| json!({ "operations": operations, "seconds": seconds.map(hundredths) });
        json!({
            "command": "cargo xtask bench --only long",
            "runs": self.runs,
            "functions": self.rows.iter().map(row).collect::<Vec<_>>(),
        })
    }

    /// Formats the result for people.
    pub fn table(&self) -> String {
        let mut text = format!(
            "generation of one function, processor seconds, {} runs each\n\n{:>10} {:>8} {:>8} {:>8}\n",
            self.runs, "operations", "smallest", "median", "largest"
        );
        for (operations, [low, median, high]) in &self.rows {
            let _ = writeln!(text, "{operations:>10} {low:>8.2} {median:>8.2} {high:>8.2}");
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
        for run in 1..=runs {
            workspace.set_source(&source(operations, run)).map_err(failed)?;
            let before = all_seconds()?;
            generate::generate(&job).map_err(|error| error.to_string())?;
            times.push(all_seconds()? - before);
            tick();
        }
        fs::remove_dir_all(&job.output).map_err(failed)?;
        rows.push((operations, spread(times)));
    }
    Ok(Long { runs, rows })
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
