//! Measures the duration of a generation, by number of functions, and for the corpus.
//!
//! Dependencies are built before. The measured part is what `cargo xtask gen` does after cargo has nothing left to
//! build: it runs the package's program for its tree, and compiles that to C. The result is the least real time of
//! several runs.

use std::fmt::Write as _;
use std::time::Instant;

use bessemer_codegen::compile::{self, Options};
use bessemer_codegen::generate::{self, Job};
use bessemer_frontend::source::Sources;
use bessemer_tests::workspace::Workspace;
use serde_json::{Value, json};

use crate::check_cost::{hundredths, source};

/// Numbers of functions of the measured packages.
const SIZES: [usize; 3] = [10, 100, 1000];

/// Measured durations.
#[derive(Clone, Debug)]
pub struct Generation {
    /// Number of runs of each package.
    pub runs: usize,
    /// For each package: number of functions, and milliseconds for its tree and for its C.
    pub synthetic: Vec<(usize, f64, f64)>,
    /// For the corpus: number of functions, and milliseconds for its tree and for its C.
    pub corpus: (usize, f64, f64),
}

impl Generation {
    /// Formats the result for machines.
    pub fn json(&self) -> Value {
        let row = |(functions, tree, c): &(usize, f64, f64)| {
            json!({
                "functions": functions,
                "tree_milliseconds": hundredths(*tree),
                "c_milliseconds": hundredths(*c),
                "per_function": hundredths((tree + c) / *functions as f64),
            })
        };
        json!({
            "command": "cargo xtask bench --only generation",
            "runs": self.runs,
            "synthetic": self.synthetic.iter().map(row).collect::<Vec<_>>(),
            "corpus": row(&self.corpus),
        })
    }

    /// Formats the result for people.
    pub fn table(&self) -> String {
        let mut text = format!(
            "generation once built, ms, least of {} runs\n\n{:<12} {:>9} {:>9} {:>9} {:>13}\n",
            self.runs, "", "functions", "tree", "C", "per function"
        );
        let rows = self.synthetic.iter().map(|row| ("synthetic", row));
        for (name, (functions, tree, c)) in rows.chain([("corpus", &self.corpus)]) {
            let each = (tree + c) / *functions as f64;
            let _ = writeln!(text, "{name:<12} {functions:>9} {tree:>9.1} {c:>9.1} {each:>13.2}");
        }
        text
    }
}

/// Measures all packages; calls `tick` after each.
///
/// # Errors
///
/// The message of cargo, the generator or the file system.
pub fn measure(runs: usize, mut tick: impl FnMut()) -> Result<Generation, String> {
    let mut synthetic = Vec::new();
    for functions in SIZES {
        let workspace = Workspace::with_source(&source(functions, true, 0))
            .map_err(|error| error.to_string())?;
        synthetic.push(timed(&workspace.path(""), "models", runs)?);
        tick();
    }
    let corpus = timed(&bessemer_tests::root(), "corpus", runs)?;
    tick();
    Ok(Generation { runs, synthetic, corpus })
}

/// The number of functions of a package, and the milliseconds for its tree and for its C.
fn timed(root: &std::path::Path, package: &str, runs: usize) -> Result<(usize, f64, f64), String> {
    let sources = Sources::new(root);
    // Builds what is not built yet.
    let job = Job::new(root, package);
    let built = generate::tree(&job).map_err(|error| error.to_string())?.package;
    let (mut least_tree, mut least_c) = (f64::INFINITY, f64::INFINITY);
    let mut functions = built.functions.len();
    for _ in 0..runs {
        let start = Instant::now();
        let tree = generate::tree(&job).map_err(|error| error.to_string())?.package;
        least_tree = least_tree.min(milliseconds(start));
        let start = Instant::now();
        let compiled = compile::compile(&tree, &sources, &Options::default())
            .map_err(|_| "the package does not compile".to_owned())?;
        least_c = least_c.min(milliseconds(start));
        functions = compiled.module.functions.len();
    }
    Ok((functions, least_tree, least_c))
}

fn milliseconds(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1000.0
}
