//! Measures what the attributes add to `cargo check` of a model.
//!
//! Two packages of the same functions, one with attributes and one without, are checked alternately, each after a
//! change of its source; dependencies are built before. The result is the processor time of cargo and rustc, which
//! depends less on other load than wall time.

use std::fmt::Write as _;
use std::fs;
use std::process::Command;

use bessemer_tests::workspace::Workspace;
use serde_json::{Value, json};

/// Number of functions, and number of repetitions.
#[derive(Clone, Copy, Debug)]
pub struct Size {
    /// Functions in the package.
    pub functions: usize,
    /// Checks of each variant.
    pub runs: usize,
}

/// Processor seconds of each variant: smallest, median, largest; and the ratio of the medians.
#[derive(Clone, Debug)]
pub struct Cost {
    /// Size that was measured.
    pub size: Size,
    /// Processor seconds without attributes.
    pub plain: [f64; 3],
    /// Processor seconds with attributes.
    pub annotated: [f64; 3],
}

impl Cost {
    /// Returns the ratio of the medians, with attributes to without.
    pub fn ratio(&self) -> f64 {
        self.annotated[1] / self.plain[1]
    }

    /// Formats the result for machines.
    pub fn json(&self) -> Value {
        json!({
            "command": "cargo xtask bench",
            "functions": self.size.functions,
            "runs": self.size.runs,
            "plain_seconds": self.plain.map(hundredths),
            "annotated_seconds": self.annotated.map(hundredths),
            "ratio": hundredths(self.ratio()),
        })
    }

    /// Formats the result for people.
    pub fn table(&self) -> String {
        let mut text = format!(
            "cargo check of {} functions, processor seconds, {} runs each, interleaved\n\n",
            self.size.functions, self.size.runs
        );
        let _ = writeln!(text, "{:<20} {:>8} {:>8} {:>8}", "", "smallest", "median", "largest");
        for (name, row) in [("without attributes", self.plain), ("with attributes", self.annotated)]
        {
            let [low, median, high] = row;
            let _ = writeln!(text, "{name:<20} {low:>8.2} {median:>8.2} {high:>8.2}");
        }
        let _ = writeln!(text, "\nratio of the medians: {:.2}", self.ratio());
        text
    }
}

/// Measures both variants; calls `tick` after each check.
///
/// # Errors
///
/// The message of cargo or the file system.
pub fn measure(size: Size, mut tick: impl FnMut()) -> Result<Cost, String> {
    let failed = |error: std::io::Error| error.to_string();
    let workspaces = [false, true].map(|annotated| {
        Workspace::with_source(&source(size.functions, annotated, 0)).map_err(failed)
    });
    let mut times = [Vec::new(), Vec::new()];
    for run in 0..=size.runs {
        for (index, workspace) in workspaces.iter().enumerate() {
            let workspace = workspace.as_ref().map_err(Clone::clone)?;
            let text = source(size.functions, index == 1, run);
            workspace.set_source(&text).map_err(failed)?;
            let before = children_seconds()?;
            let output = Command::new("cargo")
                .args(["check", "--quiet", "--offline", "--package", "models"])
                .current_dir(workspace.path(""))
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
    let [plain, annotated] = times.map(spread);
    Ok(Cost { size, plain, annotated })
}

/// Rounds to hundredths, the resolution of the clock.
pub(crate) fn hundredths(value: f64) -> f64 {
    (100.0 * value).round() / 100.0
}

pub(crate) fn spread(mut times: Vec<f64>) -> [f64; 3] {
    times.sort_by(f64::total_cmp);
    [times[0], times[times.len() / 2], times[times.len() - 1]]
}

/// Processor seconds of all children that have ended (`proc(5)`: `cutime` and `cstime`).
pub(crate) fn children_seconds() -> Result<f64, String> {
    seconds(&[13, 14])
}

/// Returns the processor time of the children plus that of this process (`utime` and `stime`).
pub(crate) fn all_seconds() -> Result<f64, String> {
    seconds(&[11, 12, 13, 14])
}

fn seconds(wanted: &[usize]) -> Result<f64, String> {
    let stat = fs::read_to_string("/proc/self/stat").map_err(|error| error.to_string())?;
    let fields: Vec<&str> =
        stat.rsplit(')').next().unwrap_or_default().split_whitespace().collect();
    let ticks = |index: &usize| fields.get(*index).and_then(|field| field.parse::<f64>().ok());
    let all: Option<Vec<f64>> = wanted.iter().map(ticks).collect();
    // The kernel reports to user space in hundredths, whatever its own clock.
    let seconds = all.map(|all| all.iter().sum::<f64>() / 100.0);
    seconds.ok_or_else(|| "/proc/self/stat has no times".into())
}

/// Generates a package of `functions` functions of 22 lines, similar to those of a model.
pub fn source(functions: usize, annotated: bool, run: usize) -> String {
    let attribute = |text: &'static str| if annotated { text } else { "" };
    let mut text = format!(
        "//! Run {run}.\n#![no_std]\n#![allow(unused_imports)]\nuse bessemer::prelude::*;\n\n\
         /// Gains.\n{}#[derive(Clone, Copy, Debug, Default, PartialEq)]\npub struct Gains {{\n    \
         /// Proportional.\n    pub p: f64,\n    /// Integral.\n    pub i: f64,\n    /// Derivative.\n    pub d: f64,\n}}\n",
        attribute("#[data]\n")
    );
    for n in 0..functions {
        let _ = write!(
            text,
            "\n/// Function {n}.\n{}pub fn law_{n}(gains: &Gains, error: &Vector3<f64>, limit: f64) -> Vector3<f64> {{{BODY}}}\n",
            attribute("#[function]\n")
        );
    }
    text
}

const BODY: &str = "
    let scaled = error * gains.p;
    let square = Matrix3::new(
        error.x, error.y, 0.0,
        0.0, error.z, error.x,
        gains.i, 0.0, gains.d,
    );
    let turned = square * scaled;
    let mut sum = Vector3::zeros();
    let mut total = 0.0;
    for n in 0..3 {
        if turned[n] > limit {
            sum[n] = limit;
        } else if turned[n] < -limit {
            sum[n] = -limit;
        } else {
            sum[n] = turned[n];
        }
        total += sum[n] * gains.d;
    }
    let rate = if total > limit { limit - total } else { total + gains.i };
    sum + turned.cross(&scaled) * rate
";
