//! Measures what the attributes add to a rebuild of the corpus, outside and inside generation builds.
//!
//! There are three variants of the same sources: without the attributes, with them, and with them in a generation
//! build. They are rebuilt alternately, each after a change of its source; dependencies are built before. The result
//! is processor time.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;

use bessemer_codegen::generate::settings;
use bessemer_tests::workspace::Workspace;
use serde_json::{Value, json};

use crate::check_cost::{children_seconds, hundredths, spread};

/// Processor seconds of each variant: smallest, median, largest.
#[derive(Clone, Debug)]
pub struct Rebuild {
    /// Number of builds of each variant.
    pub runs: usize,
    /// Lines of the sources.
    pub lines: usize,
    /// Processor seconds without attributes.
    pub plain: [f64; 3],
    /// Processor seconds with attributes.
    pub annotated: [f64; 3],
    /// Processor seconds with attributes in a generation build.
    pub generating: [f64; 3],
}

impl Rebuild {
    /// Returns the median of a variant divided by the median without attributes.
    fn ratio(&self, variant: [f64; 3]) -> f64 {
        variant[1] / self.plain[1]
    }

    /// Formats the result for machines.
    pub fn json(&self) -> Value {
        json!({
            "command": "cargo xtask bench --only rebuild",
            "runs": self.runs,
            "lines": self.lines,
            "plain_seconds": self.plain.map(hundredths),
            "annotated_seconds": self.annotated.map(hundredths),
            "generating_seconds": self.generating.map(hundredths),
            "annotated_ratio": hundredths(self.ratio(self.annotated)),
            "generating_ratio": hundredths(self.ratio(self.generating)),
        })
    }

    /// Formats the result for people.
    pub fn table(&self) -> String {
        let mut text = format!(
            "rebuild of the corpus ({} lines), processor seconds, {} runs each, interleaved\n\n",
            self.lines, self.runs
        );
        let _ = writeln!(
            text,
            "{:<22} {:>8} {:>8} {:>8} {:>8}",
            "", "smallest", "median", "largest", "ratio"
        );
        for (name, row) in [
            ("without attributes", self.plain),
            ("with attributes", self.annotated),
            ("in a generation build", self.generating),
        ] {
            let [low, median, high] = row;
            let ratio = self.ratio(row);
            let _ = writeln!(text, "{name:<22} {low:>8.2} {median:>8.2} {high:>8.2} {ratio:>8.2}");
        }
        text
    }
}

/// Measures all variants; calls `tick` after each build.
///
/// # Errors
///
/// The message of cargo or the file system.
pub fn measure(runs: usize, mut tick: impl FnMut()) -> Result<Rebuild, String> {
    let failed = |error: std::io::Error| error.to_string();
    let programs = bessemer_tests::root().join("tests/corpus/src/programs");
    let mut lines = 0;
    let mut workspaces = Vec::new();
    for annotated in [false, true] {
        let workspace = Workspace::with_source("").map_err(failed)?;
        let modules = copied(&programs, &workspace.folder().join("src"), annotated, &mut lines)
            .map_err(failed)?;
        workspaces.push((workspace, modules));
    }
    // As `cargo xtask gen` builds it.
    let mut generating = vec!["--features".to_owned(), "bessemer/generate".to_owned()];
    generating.extend(settings("models").flat_map(|it| ["--config".to_owned(), it]));
    let variants: [(usize, &[String]); 3] = [(0, &[]), (1, &[]), (1, &generating)];
    let mut times = [Vec::new(), Vec::new(), Vec::new()];
    for run in 0..=runs {
        for (index, (workspace, features)) in variants.into_iter().enumerate() {
            let (workspace, modules) = &workspaces[workspace];
            let text = format!(
                "//! Run {run}.\n#![allow(warnings, clippy::all)]\nuse bessemer::prelude::*;\n{modules}"
            );
            workspace.set_source(&text).map_err(failed)?;
            let before = children_seconds()?;
            let output = Command::new("cargo")
                .args(["build", "--quiet", "--offline", "--package", "models", "--lib"])
                .args(features)
                .current_dir(workspace.path(""))
                // The whole crate, not what rustc finds changed in it.
                .env("CARGO_INCREMENTAL", "0")
                .output()
                .map_err(failed)?;
            if !output.status.success() {
                return Err(String::from_utf8_lossy(&output.stderr).into_owned());
            }
            // The first round builds the dependencies.
            if run > 0 {
                times[index].push(children_seconds()? - before);
                tick();
            }
        }
    }
    let [plain, annotated, generating] = times.map(spread);
    Ok(Rebuild { runs, lines: lines / 2, plain, annotated, generating })
}

/// Programs that rustc takes only below the attributes, which give what they call, or that need another crate: left out of all
/// three.
const NEEDY: [&str; 4] =
    ["complex_numbers", "named_iterators", "other_crates", "powers_of_matrices"];

/// Copies a folder of programs and returns the text of its modules; without attributes unless `annotated` is set.
fn copied(from: &Path, to: &Path, annotated: bool, lines: &mut usize) -> std::io::Result<String> {
    fs::create_dir_all(to)?;
    let mut paths = fs::read_dir(from)?
        .map(|entry| entry.map(|it| it.path()))
        .collect::<Result<Vec<_>, _>>()?;
    paths.sort();
    let mut modules = String::new();
    for path in paths {
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if NEEDY.contains(&name.as_str()) {
            continue;
        }
        let target = to.join(path.file_name().unwrap_or_default());
        if path.is_dir() {
            let inner = copied(&path, &target, annotated, lines)?;
            if !path.join("mod.rs").exists() {
                fs::write(target.join("mod.rs"), inner)?;
            }
        } else {
            let text = fs::read_to_string(&path)?;
            *lines += text.lines().count();
            fs::write(target, if annotated { text } else { bare(&text) })?;
        }
        // What files include is no module.
        let is_module = path.is_dir() || path.extension().is_some_and(|it| it == "rs");
        if is_module && name != "mod" {
            let _ = writeln!(modules, "pub mod {name};");
        }
    }
    Ok(modules)
}

/// Names of the DSL's attributes.
const OWN: [&str; 12] = [
    "data",
    "component",
    "function",
    "entry",
    "bound",
    "interface",
    "external",
    "unit",
    "range",
    "c",
    "unroll",
    "keep",
];

/// Removes the DSL's attributes from a text, and lines that held nothing else.
fn bare(text: &str) -> String {
    let kept = text.lines().filter_map(|line| {
        let rest = without(line);
        (rest.len() == line.len() || !rest.trim().is_empty()).then(|| rest + "\n")
    });
    kept.collect()
}

/// Removes the DSL's attributes from a line, wherever in it they begin.
fn without(line: &str) -> String {
    let mut parts = line.split("#[");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |kept, part| match behind(part) {
        Some(rest) => kept + rest.trim_start(),
        None => kept + "#[" + part,
    })
}

/// Parses an attribute after its `#[`, and returns the text after it; `None` if it is not one of the DSL's.
fn behind(attribute: &str) -> Option<&str> {
    let name = attribute.split(['(', ']']).next()?;
    let rest = OWN.contains(&name).then(|| &attribute[name.len()..])?;
    rest.strip_prefix(']').or_else(|| rest.split_once(")]").map(|(_, rest)| rest))
}
