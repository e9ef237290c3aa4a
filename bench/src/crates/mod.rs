//! Compares crates of other authors with their C, to the bit: the original, the marked copy, and the C of the copy.
//!
//! `bench/crates/NAME-VERSION/` holds our files: the attributes and imports (`marks`), the few changed lines (`edits`), functions that use the crate by
//! numbers alone (`drive.rs`), and inputs from the crate's own tests (`inputs`). The sources come from cargo's registry and stay under `target/`.
//!
//! It must not know what a crate computes.

mod legs;
mod native;
pub mod page;
mod signature;
mod source;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use bessemer_tests::root;
use serde_json::{Value, json};

pub use legs::Counts;
pub use source::{Crate, all, vendored};

/// The result of trying a crate.
pub struct Trial {
    /// The crate.
    pub of: Crate,
    /// Numbers of attributes, of imports and of changed lines.
    pub marks: [usize; 3],
    /// Results of the comparison, or the error that prevented it.
    pub outcome: Result<Counts, String>,
}

/// Tries a crate whose sources are in a folder; calls `say` with each step.
pub fn tried(of: &Crate, sources: &std::path::Path, say: &dyn Fn(&str)) -> Trial {
    let mut marks = [0; 3];
    let outcome = source::lay_out(of, sources).and_then(|laid| {
        marks = laid.marks;
        legs::compare(of, &laid, say)
    });
    Trial { of: of.clone(), marks, outcome }
}

impl Trial {
    /// Returns true if the crate becomes C whose bits are Rust's.
    pub fn passes(&self) -> bool {
        self.outcome.as_ref().is_ok_and(|counts| counts.legs == 0)
    }

    /// Formats the trial for `bench/results/crates.json`.
    pub fn json(&self) -> Value {
        let [attributes, imports, changed] = self.marks;
        let mut row = json!({
            "crate": self.of.name,
            "version": self.of.version,
            "attributes": attributes,
            "imports": imports,
            "changed_lines": changed,
        });
        match &self.outcome {
            Ok(counts) => {
                row["entries"] = json!(counts.entries);
                row["calls"] = json!(counts.calls);
                row["inputs_of_its_tests"] = json!(counts.of_tests);
                row["differ_between_legs"] = json!(counts.legs);
                row["differ_from_the_original"] = json!(counts.original);
                row["of_its_tests_differ"] = json!(counts.tests_differ);
                row["most_ulp"] = json!(counts.ulp);
            }
            Err(said) => {
                let first = said.lines().find(|line| line.starts_with("error"));
                row["stopped_by"] = json!(first.unwrap_or(said.lines().next().unwrap_or_default()));
                row["errors"] =
                    json!(said.lines().filter(|line| line.starts_with("error")).count());
            }
        }
        row
    }

    /// Formats the trial as one line for people.
    pub fn line(&self) -> String {
        let [attributes, imports, changed] = self.marks;
        let mut text = format!(
            "{:<24} {:<8} {attributes:>4} {imports:>4} {changed:>4} ",
            self.of.name, self.of.version
        );
        let _ = match &self.outcome {
            Ok(it) => write!(
                text,
                "{:>4} {:>6} {:>5} {:>5} {:>5} {:>4}",
                it.entries, it.calls, it.of_tests, it.legs, it.original, it.ulp
            ),
            Err(said) => write!(text, "{}", said.lines().next().unwrap_or_default()),
        };
        text
    }
}

/// Heading of the lines of [`Trial::line`].
pub const HEAD: &str =
    "crate                    version  attr  use edit  fns  calls tests  legs  orig  ulp";

/// Replaces this run's rows in the result file.
///
/// # Errors
///
/// An error of the file system, or a result file that is not JSON.
pub fn store(trials: &[Trial]) -> Result<(), String> {
    let path = results();
    let failed = |error: &dyn std::fmt::Display| format!("`{}`: {error}", path.display());
    let mut rows = BTreeMap::<String, Value>::new();
    if path.exists() {
        let text = fs::read_to_string(&path).map_err(|error| failed(&error))?;
        let old: Value = serde_json::from_str(&text).map_err(|error| failed(&error))?;
        for row in old["crates"].as_array().into_iter().flatten() {
            rows.insert(row["crate"].as_str().unwrap_or_default().to_owned(), row.clone());
        }
    }
    for trial in trials {
        rows.insert(trial.of.name.clone(), trial.json());
    }
    let order = all()?;
    let rows: Vec<Value> = order.iter().filter_map(|it| rows.remove(&it.name)).collect();
    let all = json!({ "command": "cargo xtask crates", "crates": rows });
    fs::write(&path, format!("{all:#}\n")).map_err(|error| failed(&error))
}

/// The path of the result file.
pub fn results() -> PathBuf {
    root().join("bench/results/crates.json")
}
