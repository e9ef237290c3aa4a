//! Cost of generating one long function by its number of operations: rustc's part must grow linearly, not
//! quadratically.
//!
//! All of it is measured, cargo, rustc, the linker and the C, as in `cargo xtask gen`; what the package depends on is built before. Each
//! time every line of the function is another, so that rustc's notes of the build before help it as little as they can. The time is
//! that of the processors.

use std::fmt::Write as _;
use std::fs;

use bessemer_codegen::generate::{self, Job};
use bessemer_tests::workspace::Workspace;
use serde_json::{Value, json};

use crate::check_cost::{all_seconds, hundredths, spread};

/// Operations of the function: additions, products, comparisons, choices, `clamp`.
const SIZES: [usize; 3] = [500, 1000, 2000];

/// The times that were measured.
#[derive(Clone, Debug)]
pub struct Long {
    /// Number of generations of each.
    pub runs: usize,
    /// Operations, and processor seconds: smallest, median, largest.
    pub rows: Vec<(usize, [f64; 3])>,
}

impl Long {
    /// For machines.
    pub fn json(&self) -> Value {
        let row = |(operations, seconds): &(usize, [f64; 3])| json!({ "operations": operations, "seconds": seconds.map(hundredths) });
        json!({
            "command": "cargo xtask bench --only long",
            "runs": self.runs,
            "functions": self.rows.iter().map(row).collect::<Vec<_>>(),
        })
    }

    /// For people.
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

/// Measures; `tick` is called after each generation.
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

/// A function of so many operations, ten in four lines, as a controller has them.
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
