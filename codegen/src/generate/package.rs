//! Runs the generation build of a package, and the program that prints its tree.
//!
//! The build is cargo's build of the package's library with the DSL's feature `generate`, so the package itself needs
//! neither a feature nor a program. rustc's errors about builders are reported in the author's terms.

use std::io::{BufRead, BufReader, IsTerminal, Read};
use std::path::{Path, PathBuf};
use std::process::Stdio;

use bessemer_ir::tree::Package;
use serde_json::Value;

use super::error::Error;
use super::job::Job;
use super::program::{self, Built, Program};
use super::reported;
use super::workspace::{Workspace, cargo, program as cargo_program};
use crate::deep;
use bessemer_frontend::diagnostic::{Diagnostic, Level, Told};
use bessemer_frontend::source::Sources;

/// Lock that is held from a build to the linking of its result, so that no other build replaces it.
const BUILDS: &str = ".bessemer-lock";

/// Largest number of builds if a result turns out to be another workspace's.
const TRIES: usize = 10;

/// A package as its author wrote it.
pub struct Tree {
    /// Types and functions.
    pub package: Package,
    /// Warnings of rustc about its source.
    pub warnings: Vec<Diagnostic>,
}

/// Returns the tree of a package, with rustc's warnings.
pub(super) fn tree(job: &Job, workspace: &Workspace, sources: &Sources) -> Result<Tree, Error> {
    let member = workspace.agreed(&job.package)?;
    let library = member.models()?;
    let license = job.license.as_ref().or(member.license.as_ref());
    let license = license.ok_or_else(|| Error::NoLicense { package: job.package.clone() })?;
    if license.contains(char::is_control) || ["/*", "*/"].iter().any(|it| license.contains(it)) {
        return Err(Error::License { package: job.package.clone(), license: license.clone() });
    }
    let failed = |reason: String| Error::Tree { package: job.package.clone(), reason };
    let mut why = "another workspace keeps building into the same target folder".to_owned();
    let mut anew: Vec<PathBuf> = Vec::new();
    for _ in 0..TRIES {
        let alone = workspace.alone(BUILDS)?;
        for source in &anew {
            program::touch(source)?;
        }
        let (built, warnings) = build(job, sources, Builds::Trees)?;
        let variables = [("CARGO_PKG_NAME", job.package.as_str()), ("CARGO_PKG_LICENSE", license)];
        let text = format!("bessemer::print_tree!({library});\n");
        let program = match built.link(&job.root, library, &text, &variables)? {
            Ok(program) => program,
            Err(said) => {
                why = said;
                continue;
            }
        };
        // It runs as long as the models are large; nothing that it needs is built over.
        drop(alone);
        let printed = program.run(library)?;
        // What was just built anew is this workspace's, though it says nothing.
        let silent = printed.silent.filter(|source| !anew.contains(source));
        anew = printed.strangers.into_iter().chain(silent).collect();
        // Of what is another workspace's, neither a tree nor a panic is this one's.
        if !anew.is_empty() {
            continue;
        }
        if !printed.success {
            return Err(match panicked(&printed.error, sources) {
                Some(reported) => Error::Refused(Told::new(vec![reported], sources, job.colour)),
                None => failed(printed.error),
            });
        }
        let read = || bessemer_ir::tree::read(&printed.tree);
        let package = deep::deep(read).map_err(|error| failed(error.to_string()))?;
        return Ok(Tree { package, warnings });
    }
    Err(failed(why))
}

/// Returns a diagnostic for a panic of the author's Rust at generation, at its line: `thread 'main' panicked at
/// src/pid.rs:3:9:`, with the message below it.
fn panicked(error: &str, sources: &Sources) -> Option<Diagnostic> {
    let (_, at) = error.split_once(" panicked at ")?;
    let (place, said) = at.split_once(":\n")?;
    let mut parts = place.rsplitn(3, ':');
    let column = parts.next()?.parse().ok()?;
    let line = parts.next()?.parse().ok()?;
    // A library that is not the workspace's has a whole path.
    let file = parts.next().filter(|file| Path::new(file).is_relative())?.to_owned();
    sources.line(&file, line)?;
    let said = said.split("\nnote: ").next()?.trim();
    Some(Diagnostic {
        file,
        line,
        column,
        message: format!("this panics during generation: {said}"),
        help: "generation computes initial values: write a `Default` that does not panic"
            .to_owned(),
        ..Diagnostic::default()
    })
}

/// Returns cargo's `--config` settings for a generation build of a package. Its program runs once to print the tree,
/// so the builders need neither optimisation nor debug information. The macros and their dependencies keep the
/// workspace's settings, since other builds use them, too.
pub fn settings(package: &str) -> impl Iterator<Item = String> {
    let of = |package: &str| {
        ["opt-level=0", "debug=false"].map(|it| format!("profile.dev.package.{package}.{it}"))
    };
    let whole = "profile.dev.panic=\"unwind\"".to_owned();
    [package, "bessemer"].into_iter().flat_map(of).chain([whole])
}

/// Size of rustc's stack in a generation build, bytes. In the witness copy each value is inside a call, so the
/// author's expressions nest three times as deep there. Only used pages take memory.
const RUSTC_STACK: usize = 1 << 30;

/// Builds a native program from `text`, linked with the package without builders. Returns rustc's messages, one per
/// line, if the text does not compile.
pub(super) fn native(
    job: &Job,
    workspace: &Workspace,
    sources: &Sources,
    (text, names): (&str, bool),
) -> Result<Result<Program, String>, Error> {
    let library = workspace.member(&job.package)?.models()?;
    let _alone = workspace.alone(BUILDS)?;
    let (mut built, _) = build(job, sources, Builds::Native { names })?;
    if workspace.may_share() {
        let found = built.found_in(&workspace.root);
        for source in &found {
            program::touch(source)?;
        }
        if !found.is_empty() {
            (built, _) = build(job, sources, Builds::Native { names })?;
        }
    }
    built.link(&job.root, library, text, &[])
}

/// The purpose of a build.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Builds {
    /// The builders of trees.
    Trees,
    /// A program around the package, which reads names from words if `names` is true.
    Native { names: bool },
}

/// Builds the package and its dependencies; in a generation build, with their builders. Also returns rustc's
/// warnings.
fn build(job: &Job, sources: &Sources, builds: Builds) -> Result<(Built, Vec<Diagnostic>), Error> {
    let mut command = cargo(&["build", "--lib"]);
    command
        .args(["--message-format=json-diagnostic-rendered-ansi", "--package", &job.package])
        .current_dir(&job.root)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    if builds == (Builds::Native { names: true }) {
        command.args(["--features", "bessemer/names"]);
    }
    if builds == Builds::Trees {
        command.args(["--features", "bessemer/generate"]);
        if std::env::var_os("RUST_MIN_STACK").is_none() {
            command.env("RUST_MIN_STACK", RUSTC_STACK.to_string());
        }
        settings(&job.package).for_each(|it| _ = command.args(["--config", &it]));
    }
    let failed = |source| Error::Run { program: cargo_program(), source };
    let mut child = command.spawn().map_err(failed)?;
    let voice = child.stderr.take().map(|lines| std::thread::spawn(move || heard(lines)));
    let output = child.wait_with_output().map_err(failed)?;
    let stderr = voice.and_then(|it| it.join().ok()).unwrap_or_default();
    let text = String::from_utf8_lossy(&output.stdout);
    let messages: Vec<Value> =
        text.lines().filter_map(|line| serde_json::from_str(line).ok()).collect();
    let said = reported::reported(&messages, sources);
    if output.status.success() {
        return Ok((Built::of(&messages), said));
    }
    // What is warned of may come from what is wrong.
    let errors: Vec<_> = said.into_iter().filter(|it| it.level == Level::Error).collect();
    if !errors.is_empty() {
        return Err(Error::Models(Told::new(errors, sources, job.colour)));
    }
    Err(Error::Models(Told::plain(stderr.trim().to_owned())))
}

/// Reads what cargo prints, and passes its progress through if somebody sees it: a first build takes minutes.
fn heard(lines: impl Read) -> String {
    let seen = std::io::stderr().is_terminal();
    let mut text = String::new();
    for line in BufReader::new(lines).lines().map_while(Result::ok) {
        if !is_progress(&line) {
            text += &line;
            text.push('\n');
        } else if seen {
            eprintln!("{line}");
        }
    }
    text
}

/// Returns true for a line of cargo that reports progress, and no error.
fn is_progress(line: &str) -> bool {
    const VERBS: [&str; 9] = [
        "Blocking",
        "Compiling",
        "Downloaded",
        "Downloading",
        "Finished",
        "Locking",
        "Adding",
        "Updating",
        "Waiting",
    ];
    // Cargo puts a verb of progress behind spaces; an error is at the margin.
    line.starts_with(' ') && VERBS.iter().any(|verb| line.trim_start().starts_with(verb))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn progress_is_passed_through_and_errors_are_kept() {
        let lines = "    Blocking waiting for file lock on build directory\n   Compiling motor v0.1.0\n\
                     error: no such feature\n\n    Finished `dev` profile\n";
        assert_eq!(heard(lines.as_bytes()), "error: no such feature\n\n");
        assert!(is_progress("  Downloading 3 crates") && !is_progress("error: could not compile"));
    }
}
