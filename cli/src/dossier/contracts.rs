//! Contracts of the small functions of the C that Frama-C's WP proves.
//!
//! The C is emitted anew with contracts, which changes its comments alone. The steps of a prover end before its time does, so
//! the count of proved goals does not depend on the speed of a machine. A goal without a proof is no failure.

use std::path::Path;
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_dossier::content::{Outcome, Proved};
use bessemer_dossier::trace::{File, Folder};
use bessemer_legs::process;
use bessemer_project::Project;

use super::checks::{FAILED, NOT_RUN, PASSED, version};
use super::{joined, outcome};

/// The check on the page.
const WHAT: &str = "Contracts, by Frama-C's WP";
const COMMAND: &str = "frama-c -wp -wp-rte";
/// Provers that WP can use, from the cheapest; their programs have the same names. Without one WP simplifies only.
const PROVERS: [&str; 3] = ["alt-ergo", "cvc4", "z3"];
/// Seconds that a prover may take for a goal, which no goal takes.
const SECONDS: &str = "120";
/// Steps that a prover may take for a goal.
const STEPS: &str = "20000";

/// Most statements of a function that is proved: the goals of a long one take minutes.
const SMALL: usize = 8;
/// Macros by which the C does without the headers of processors, which Frama-C lacks.
const PLAIN: &str = "-DBESSEMER_PLAIN -U__SSE2__ -U__AVX__";

/// Proves contracts. Returns the outcome, and a row for each function.
pub fn proved(project: &Project, compiled: &Compiled, c: &Folder) -> (Outcome, Vec<Proved>) {
    let provers = PROVERS.map(|it| (it, version(it)));
    let provers: Vec<_> = provers.into_iter().filter(|it| !it.1.is_empty()).collect();
    let frama = frama();
    let of = |verdict, detail: &str| {
        let all =
            [format!("Frama-C {frama}")].into_iter().chain(provers.iter().map(|it| it.1.clone()));
        let versions = all.collect::<Vec<_>>().join("; ");
        outcome(WHAT, COMMAND, versions, verdict, detail.to_owned())
    };
    if frama.is_empty() {
        let why = "frama-c is not installed (Debian: frama-c-base, why3, z3, cvc4)".to_owned();
        return (outcome(WHAT, COMMAND, String::new(), NOT_RUN, why), Vec::new());
    }
    let options = Options { contracts: true, hook: None, ..project.settings.options.clone() };
    let compiled = match compiled.anew(&options) {
        Ok(compiled) => compiled,
        Err(wrong) => {
            let said = wrong.first().map(|it| it.message.clone()).unwrap_or_default();
            return (of(FAILED, &said), Vec::new());
        }
    };
    let folder = match process::lay_out(&compiled) {
        Ok(folder) => folder,
        Err(error) => return (of(FAILED, &error.to_string()), Vec::new()),
    };
    let names: Vec<&str> = provers.iter().map(|it| it.0).collect();
    let provers = if names.is_empty() { "none".to_owned() } else { names.join(",") };
    let inlined = inlined(&compiled);
    let prover = Prover { folder: folder.path(), provers, inlined };
    let small = |file: &File| {
        let small = file.functions.iter().filter(|it| it.statements.len() <= SMALL);
        small.map(|it| it.name.clone()).collect::<Vec<_>>()
    };
    let files = c.files.iter().filter(|it| it.name.ends_with(".c") && !it.rows.is_empty());
    let files: Vec<_> = files.map(|it| (it.name.as_str(), small(it))).collect();
    let mut rows = prover.all(&files);
    rows.sort_by(|one, other| one.function.cmp(&other.function));
    rows.dedup();
    let sum = |of: fn(&Proved) -> u64| rows.iter().map(of).sum::<u64>();
    let whole = rows.iter().filter(|it| it.goals > 0 && it.proved == it.goals).count();
    let detail = format!(
        "{} of {} goals proved; {whole} of {} functions with at most {SMALL} statements wholly",
        sum(|it| it.proved),
        sum(|it| it.goals),
        rows.len()
    );
    match sum(|it| it.goals) {
        0 if rows.is_empty() => {
            let why = format!("no function has at most {SMALL} statements");
            (of(NOT_RUN, &why), rows)
        }
        0 => (of(NOT_RUN, "WP ends early at each function"), rows),
        _ => (of(PASSED, &detail), rows),
    }
}

/// Returns the helpers whose bodies WP sees at each call. One that copies the bits of a number is not among them: WP's model of
/// memory has types.
fn inlined(compiled: &Compiled) -> String {
    let mut names = Vec::new();
    for file in compiled.files.iter().filter(|it| it.name.ends_with("_helpers.h")) {
        for text in file.text.split("static inline ").skip(1) {
            let body = text.split("\n}").next().unwrap_or_default();
            let name = text.split('(').next().and_then(|head| head.split_whitespace().last());
            let copies = body.contains("sizeof");
            names.extend(name.filter(|_| !copies).map(|it| it.trim_start_matches('*').to_owned()));
        }
    }
    names.join(",")
}

/// Runs WP.
struct Prover<'f> {
    folder: &'f Path,
    /// The provers, separated by commas.
    provers: String,
    /// Functions that are inlined, separated by commas.
    inlined: String,
}

impl Prover<'_> {
    /// Proves functions of all files, on all processors.
    fn all(&self, files: &[(&str, Vec<String>)]) -> Vec<Proved> {
        let next = AtomicUsize::new(0);
        let work = || {
            let mut rows = Vec::new();
            while let Some((file, functions)) = files.get(next.fetch_add(1, Ordering::Relaxed)) {
                rows.extend(self.of_file(file, functions));
            }
            rows
        };
        let workers = std::thread::available_parallelism().map_or(1, usize::from);
        std::thread::scope(|scope| {
            let workers: Vec<_> = (0..workers).map(|_| scope.spawn(work)).collect();
            workers.into_iter().flat_map(joined).collect()
        })
    }

    /// Proves functions of a file. WP ends at the first one that its model of memory does not have: then each on its own.
    fn of_file(&self, file: &str, functions: &[String]) -> Vec<Proved> {
        if functions.is_empty() {
            return Vec::new();
        }
        self.proved(file, functions).unwrap_or_else(|| {
            let one = |name: &String| {
                let none = Proved { function: name.clone(), proved: 0, goals: 0 };
                self.proved(file, std::slice::from_ref(name)).unwrap_or_else(|| vec![none])
            };
            functions.iter().flat_map(one).collect()
        })
    }

    /// Proves functions of a file; none if WP ends early.
    fn proved(&self, file: &str, functions: &[String]) -> Option<Vec<Proved>> {
        let report = self.folder.join(format!("{file}.wp.json"));
        let _ = std::fs::remove_file(&report);
        let mut command = Command::new("frama-c");
        command.args(["-wp", "-wp-rte", "-machdep", "gcc_x86_64"]);
        if !self.inlined.is_empty() {
            command.args(["-inline-calls", &self.inlined]);
        }
        // Infinite numbers and NaN are values as any other.
        command.args(["-warn-special-float", "none"]);
        command.args(["-wp-timeout", SECONDS, "-wp-steps", STEPS, "-wp-prover", &self.provers]);
        command.arg("-wp-fct").arg(functions.join(","));
        command.arg("-wp-report-json").arg(&report);
        command.arg(format!("-cpp-extra-args=-I{} {PLAIN}", self.folder.display()));
        command.arg(self.folder.join(file)).stdin(std::process::Stdio::null());
        command.output().ok()?;
        rows(&report)
    }
}

/// Returns the version of Frama-C; nothing if it is absent.
fn frama() -> String {
    let output = Command::new("frama-c").arg("-version").output();
    let text = output.map(|it| String::from_utf8_lossy(&it.stdout).trim().to_owned());
    text.unwrap_or_default()
}

/// Reads the report of WP: goals and proved ones by function.
fn rows(report: &Path) -> Option<Vec<Proved>> {
    let text = std::fs::read_to_string(report).ok()?;
    let json: serde_json::Value = serde_json::from_str(&text).ok()?;
    let functions = json.get("wp:functions")?.as_object()?;
    let mut rows: Vec<Proved> = functions
        .iter()
        .map(|(function, goals)| {
            let main = goals.get("wp:section").and_then(|it| it.get("wp:main"));
            let count = |key: &str| {
                main.and_then(|it| it.get(key)).and_then(serde_json::Value::as_u64).unwrap_or(0)
            };
            Proved { function: function.clone(), proved: count("valid"), goals: count("total") }
        })
        .collect();
    rows.sort_by(|one, other| one.function.cmp(&other.function));
    Some(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_report_of_wp_has_goals_by_function() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("wp.json");
        let text = r#"{ "wp:global": {}, "wp:functions": {
            "motor_step": { "motor_step_assigns": { "wp:main": { "total": 2 } },
                "wp:section": { "qed": { "total": 3 }, "wp:main": { "total": 5, "valid": 4 } } },
            "motor_init": { "wp:section": { "wp:main": { "total": 1, "valid": 1 } } } } }"#;
        std::fs::write(&path, text).expect("a file");
        let row =
            |function: &str, proved, goals| Proved { function: function.to_owned(), proved, goals };
        assert_eq!(rows(&path), Some(vec![row("motor_init", 1, 1), row("motor_step", 4, 5)]));
        assert_eq!(rows(&folder.path().join("none")), None);
    }
}
