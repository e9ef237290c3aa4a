//! Checks that a dossier runs, each with its command, versions, verdict and figures.
//!
//! Invariant: a figure has no date, no time and no path of this machine.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::Command;

use bessemer_codegen::compile::Compiled;
use bessemer_dossier::content::{Outcome, Sizes};
use bessemer_dossier::coverage::reasons::{self, Row};
use bessemer_dossier::coverage::{Missing, Report};
use bessemer_dossier::requirements::Results;
use bessemer_dossier::requirements::rust::Item;
use bessemer_legs::toolchain::{self, GCC, Toolchain};
use bessemer_project::Project;
use bessemer_words::record;
use serde_json::Value;
use tempfile::TempDir;

use super::outcome;
use crate::args::{Package, Target, Verify};
use crate::error::Error;
use crate::{sizes, verify};

/// Verdict of a check that found nothing wrong.
pub const PASSED: &str = "passed";
/// Verdict of a check that found something.
pub const FAILED: &str = "failed";
/// Verdict of a check that was not run.
pub const NOT_RUN: &str = "not run";

/// Returns the first line that a program answers to `--version`.
pub fn version(program: &str) -> String {
    let output = Command::new(program).arg("--version").output();
    let text = output.map(|it| String::from_utf8_lossy(&it.stdout).into_owned());
    text.ok().and_then(|it| it.lines().next().map(str::to_owned)).unwrap_or_default()
}

/// Returns the version of rustc.
pub fn rustc() -> String {
    let program = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_owned());
    version(&program).trim_start_matches("rustc ").to_owned()
}

/// The versions of the compilers on this machine.
fn compilers() -> String {
    let mut names: Vec<&str> = toolchain::host().iter().map(|it| it.compiler).collect();
    names.dedup();
    names.into_iter().map(version).collect::<Vec<_>>().join("; ")
}

/// The C equals the output of a new generation: it was compared before anything else.
pub fn current(compiled: &Compiled) -> Outcome {
    let files = compiled.files.len();
    let detail = format!("{files} files, equal to the byte");
    let version = format!("bessemer {}", env!("CARGO_PKG_VERSION"));
    outcome("The C is up to date", "cargo bessemer gen --check", version, PASSED, detail)
}

/// Checks that were left out.
pub fn not_run(why: &str) -> Vec<Outcome> {
    let checks = [
        ("Tests of the package", "cargo test"),
        ("Rust, interpreter and C agree", "cargo bessemer verify"),
        ("Coverage of the C", "cargo bessemer dossier"),
        ("Sanitizers", "cargo bessemer dossier"),
        ("Contracts, by Frama-C's WP", "frama-c -wp -wp-rte"),
        ("Sizes", "cargo bessemer sizes"),
    ];
    let one = |(what, command)| outcome(what, command, String::new(), NOT_RUN, why.to_owned());
    checks.map(one).to_vec()
}

/// Results of the package's tests.
pub struct Tested {
    /// Outcome of all.
    pub outcome: Outcome,
    /// Results by file and name.
    pub results: Results,
    /// Folder of the calls that the tests made through `same_bits` or recorded.
    pub calls: Option<TempDir>,
}

/// Runs the tests of the package, and those of other packages of the workspace.
pub fn tests(project: &Project, others: &[String], items: &[Item]) -> Tested {
    let what = "Tests of the package";
    let packages = std::iter::once(&project.package.name).chain(others);
    let packages: Vec<&str> = packages.flat_map(|it| ["--package", it]).collect();
    let shown = format!("cargo test {}", packages.join(" "));
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let recorded = tempfile::tempdir().ok();
    let mut command = Command::new(cargo);
    command.args(["test", "--no-fail-fast", "--color", "never"]);
    // Which source a program was built of: two packages may have tests of one name.
    command.args(["--message-format", "json-render-diagnostics"]);
    command.args(&packages).current_dir(&project.workspace.root);
    if let Some(folder) = &recorded {
        command.env(record::FOLDER, folder.path());
    }
    // Standard error names the programs, standard output the tests: both in one stream, in order.
    let said = both(&mut command);
    let none = |detail: String| Tested {
        outcome: outcome(what, &shown, rustc(), NOT_RUN, detail),
        results: Results::new(),
        calls: None,
    };
    let said = match said {
        Ok(said) => said,
        Err(error) => return none(error.to_string()),
    };
    let results = results(&said, items, &project.workspace.root);
    if results.all == 0 {
        let errors = said.lines().find(|line| line.starts_with("error"));
        let (verdict, detail) = match errors {
            Some(line) => (FAILED, line.to_owned()),
            None => (NOT_RUN, "the package has no tests".to_owned()),
        };
        let mut tested = none(detail);
        tested.outcome.verdict = verdict;
        return tested;
    }
    let verdict = if results.failed == 0 { PASSED } else { FAILED };
    let detail = format!("{} passed, {} failed", results.all - results.failed, results.failed);
    let outcome = outcome(what, &shown, rustc(), verdict, detail);
    Tested { outcome, results: results.by_name, calls: recorded }
}

fn both(command: &mut Command) -> std::io::Result<String> {
    use std::io::{Read, Seek};
    let mut file = tempfile::tempfile()?;
    command.stdout(file.try_clone()?).stderr(file.try_clone()?);
    command.stdin(std::process::Stdio::null()).status()?;
    file.rewind()?;
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

#[derive(Default)]
struct Counted {
    all: usize,
    failed: usize,
    by_name: Results,
}

/// Returns the name of a test program and its first source, from the workspace, by a message of cargo.
fn program(line: &str, root: &Path) -> Option<(String, String)> {
    let message: Value = serde_json::from_str(line).ok()?;
    let executable = message["executable"].as_str()?;
    let source = Path::new(message["target"]["src_path"].as_str()?);
    Some((file_name(executable), slashes(source.strip_prefix(root).ok()?)))
}

fn file_name(path: &str) -> String {
    path.rsplit(['/', '\\']).next().unwrap_or(path).to_owned()
}

fn slashes(path: &Path) -> String {
    path.to_string_lossy().replace('\\', "/")
}

/// Reads what `cargo test` prints, with its messages.
fn results(said: &str, items: &[Item], root: &Path) -> Counted {
    let mut found = Counted::default();
    let messages = said.lines().filter(|line| line.starts_with('{'));
    let programs: BTreeMap<_, _> = messages.filter_map(|line| program(line, root)).collect();
    // First source of the running program, from the workspace.
    let mut file = String::new();
    for line in said.lines() {
        let line = line.trim();
        if let Some(rest) = line.strip_prefix("Running ") {
            let built = rest.rsplit_once(" (").map_or(rest, |(_, it)| it.trim_end_matches(')'));
            file = programs.get(&file_name(built)).cloned().unwrap_or_default();
            continue;
        }
        if line.starts_with("Doc-tests ") {
            file.clear();
            continue;
        }
        let Some((name, verdict)) =
            line.strip_prefix("test ").and_then(|it| it.split_once(" ... "))
        else {
            continue;
        };
        let passed = match verdict.split(',').next().unwrap_or_default() {
            "ok" => true,
            "FAILED" => false,
            _ => continue,
        };
        let name = name.strip_suffix(" - should panic").unwrap_or(name);
        found.all += 1;
        found.failed += usize::from(!passed);
        let own = items.iter().filter(|it| it.is_test).find(|it| {
            in_program(&it.file, &file).is_some_and(|module| {
                let full = match module.is_empty() {
                    true => it.name.clone(),
                    false => format!("{module}::{}", it.name),
                };
                full == name
            })
        });
        if let Some(item) = own {
            found.by_name.insert(format!("{}:{}", item.file, item.name), passed);
        }
    }
    found
}

/// Returns the module of a source in the program that begins with the file `root`; none if it is in another program.
fn in_program(path: &str, root: &str) -> Option<String> {
    if path == root {
        return Some(String::new());
    }
    // Modules of a program are beside its first source.
    let (folder, _) = root.rsplit_once('/')?;
    let inner = path.strip_prefix(&format!("{folder}/"))?.strip_suffix(".rs")?;
    Some(inner.strip_suffix("/mod").unwrap_or(inner).replace('/', "::"))
}

/// Compares Rust, interpreter and C.
pub fn verified(folder: &Path, package: Option<&str>) -> Outcome {
    let what = "Rust, interpreter and C agree";
    let wanted = Verify { package: Package::of(package), ..Verify::default() };
    let (verdict, detail) = match verify::run(folder, &wanted, false) {
        Ok((text, good)) => {
            let calls = text.lines().next().unwrap_or_default();
            let calls = calls.split(';').next().unwrap_or_default().to_owned();
            let legs = text.lines().filter(|line| line.contains(" words differ"));
            let legs: Vec<String> =
                legs.map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
            (if good { PASSED } else { FAILED }, format!("{calls}; {}", legs.join("; ")))
        }
        Err(Error::NoCompiler) => (NOT_RUN, "neither gcc nor clang is installed".to_owned()),
        Err(error) => (FAILED, error.to_string()),
    };
    outcome(what, "cargo bessemer verify", compilers(), verdict, detail)
}

/// The outcomes of a measurement of coverage, and its report with the author's reasons.
///
/// # Errors
/// An error of the user's inputs.
pub fn covered(
    measured: Result<Report, Error>,
    rows: &[Row],
) -> Result<(Vec<Outcome>, Option<Report>), Error> {
    let of = |what, verdict, detail| {
        outcome(what, "cargo bessemer dossier", compilers(), verdict, detail)
    };
    let what = "Coverage of the C";
    let mut report = match measured {
        Ok(report) => report,
        Err(Error::NoCompiler) => {
            let why = "neither gcc nor clang is installed".to_owned();
            return Ok((vec![of(what, NOT_RUN, why)], None));
        }
        Err(Error::Compiler { name, said }) => {
            return Ok((vec![of(what, FAILED, format!("{name}: {}", first_error(&said)))], None));
        }
        Err(error) => return Err(error),
    };
    let counts = report.counts;
    let detail = format!(
        "statements {} of {}, branches {} of {}, MC/DC {} of {}, and {} proved impossible",
        counts.statements.covered,
        counts.statements.all,
        counts.branches.covered,
        counts.branches.all,
        counts.conditions.covered,
        counts.conditions.all,
        report.impossible
    );
    let mut outcomes = vec![of(what, PASSED, detail)];
    let unused = reasons::add(&mut report, rows);
    if !rows.is_empty() {
        let open = |list: &[Missing]| {
            list.iter().filter(|it| it.reason.is_empty() && !it.is_impossible).count()
        };
        let mut detail = format!(
            "none for {} conditions and {} statements",
            open(&report.conditions),
            open(&report.statements)
        );
        for row in &unused {
            detail += &format!("; `{}` has no `{}`", row.function, row.code);
        }
        let verdict = if unused.is_empty() { PASSED } else { FAILED };
        outcomes.push(of("Reasons for missing coverage", verdict, detail));
    }
    Ok((outcomes, Some(report)))
}

/// This machine and processors whose compilers are installed.
pub fn targets() -> Vec<(&'static str, Toolchain)> {
    let all = [Target::Zynq, Target::CortexM4f, Target::Riscv32].map(verify::machine);
    let own = ("this machine", GCC);
    let there = |it: &(&str, Toolchain)| bessemer_tools::check(&[it.1.compiler]).is_ok();
    std::iter::once(own).chain(all).filter(there).collect()
}

/// Returns the first error in a compiler's message, without the command and its paths.
pub fn first_error(said: &str) -> &str {
    // The linker's own message is above the one of the compiler that runs it.
    let linker = |line| Some(str::split_once(str::split_once(line, ".ld:")?.1, ": ")?.1);
    let compiler = |line| Some(str::split_once(line, "error: ")?.1);
    let found = said.lines().find_map(linker).or_else(|| said.lines().find_map(compiler));
    found.unwrap_or("the C was refused")
}

/// Compiles an empty function; the compiler's first error, such as a missing library of its own.
pub fn try_out(toolchain: &Toolchain) -> Result<(), String> {
    let text = "int nothing(void);\nint nothing(void)\n{\n    return 0;\n}\n";
    let compiled = tempfile::tempdir().map_err(|error| error.to_string()).and_then(|folder| {
        let source = folder.path().join("nothing.c");
        std::fs::write(&source, text).map_err(|error| error.to_string())?;
        let (object, _) = toolchain.object(&source, &[])?;
        toolchain.brought(&[object], "nothing", &folder.path().join("kept.o")).map(drop)
    });
    compiled.map_err(|said| first_error(&said).to_owned())
}

/// Measures the sizes on a target.
pub fn sizes(
    project: &Project,
    compiled: &Compiled,
    name: &str,
    toolchain: Toolchain,
) -> (Outcome, Option<Sizes>) {
    let what = format!("Sizes on {name}");
    let command = match name {
        "this machine" => "cargo bessemer sizes".to_owned(),
        name => format!("cargo bessemer sizes --target {name}"),
    };
    let compiler = version(toolchain.compiler);
    if let Err(why) = try_out(&toolchain) {
        let why = format!("the compiler fails without any C of the package: {why}");
        return (outcome(&what, &command, compiler, NOT_RUN, why), None);
    }
    match sizes::measured(compiled, &toolchain.of(project.settings.options.standard)) {
        Ok(measured) => {
            let row = |(name, it): (&String, &toolchain::Sizes)| {
                [name.clone(), it.text.to_string(), it.data.to_string(), it.bss.to_string()]
            };
            let all = ("all of the C".to_owned(), measured.all);
            let rows = measured.entries.iter().map(|(name, it)| row((name, it)));
            let rows = rows.chain([row((&all.0, &all.1))]).collect();
            let detail = format!("{} bytes of code and constants in all", all.1.text);
            let sizes = Sizes { target: format!("{name}: {compiler}, -O2"), rows };
            (outcome(&what, &command, compiler, PASSED, detail), Some(sizes))
        }
        Err(Error::Compiler { said, .. }) => {
            (outcome(&what, &command, compiler, FAILED, first_error(&said).to_owned()), None)
        }
        Err(error) => (outcome(&what, &command, compiler, FAILED, error.to_string()), None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn item(file: &str, name: &str) -> Item {
        Item {
            name: name.to_owned(),
            file: file.to_owned(),
            line: 1,
            last_line: 2,
            is_test: true,
            is_function: true,
            requirements: Vec::new(),
            words: std::collections::BTreeSet::new(),
        }
    }

    #[test]
    fn a_compilers_error_has_no_command_and_no_path() {
        let said = "cc -c /tmp/x1/a.c\n\n/tmp/x1/a.c:3:5: error: expected `;`\ncc: error: 2\n";
        assert_eq!(first_error(said), "expected `;`");
        assert_eq!(first_error("cc: fatal error: cannot read spec file"), "cannot read spec file");
        let said =
            "gcc\n/usr/bin/ld:picolibc.ld:176: undefined symbol `x'\ncc: error: ld returned 1\n";
        assert_eq!(first_error(said), "undefined symbol `x'");
        assert_eq!(first_error("killed"), "the C was refused");
        let toolchain = Toolchain { compiler: "no-such-compiler", ..GCC };
        assert_eq!(try_out(&toolchain), Err("the C was refused".to_owned()));
    }

    #[test]
    fn results_are_those_of_the_program_that_ran_the_test() {
        let items = [
            item("models/src/height.rs", "tests::holds"),
            item("models/tests/course.rs", "holds"),
            item("models/tests/gate.rs", "holds"),
            item("models/tests/shared/mod.rs", "falls"),
            item("sim/tests/course.rs", "holds"),
        ];
        let message = |name: &str, source: &str| {
            let target = json!({ "src_path": format!("/w/{source}") });
            json!({ "executable": format!("/t/{name}"), "target": target }).to_string()
        };
        let said = [
            message("models-1", "models/src/lib.rs"),
            message("course-1", "models/tests/course.rs"),
            message("course-2", "sim/tests/course.rs"),
            json!({ "reason": "build-finished" }).to_string(),
            "     Running unittests src/lib.rs (target/debug/deps/models-1)".to_owned(),
            "test height::tests::holds ... ok".to_owned(),
            "     Running tests/course.rs (target/debug/deps/course-1)".to_owned(),
            "test holds ... FAILED\ntest other ... ignored, slow".to_owned(),
            "test shared::falls - should panic ... ok".to_owned(),
            "     Running tests/course.rs (target/debug/deps/course-2)".to_owned(),
            "test holds ... ok\n   Doc-tests models\ntest holds ... ok".to_owned(),
        ];
        let found = results(&said.join("\n"), &items, Path::new("/w"));
        assert_eq!((found.all, found.failed), (5, 1));
        let one = |name: &str, passed| (name.to_owned(), passed);
        assert_eq!(
            found.by_name,
            Results::from([
                one("models/src/height.rs:tests::holds", true),
                one("models/tests/course.rs:holds", false),
                one("models/tests/shared/mod.rs:falls", true),
                one("sim/tests/course.rs:holds", true),
            ])
        );
    }
}
