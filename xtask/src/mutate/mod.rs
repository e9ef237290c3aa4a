//! `cargo xtask mutate`: introduces small defects into the compiler, and checks that tests detect them.
//!
//! Each patch in `tests/mutants/` is applied to a copy of the work tree, and the test named in its header is run
//! there. If that test passes or none is named, all tests run, from the cheapest to the most expensive, until one
//! fails. A mutant that no test detects is a gap in the tests. A mutant that does not compile, or that another test
//! detects, is a mistake in its file. Each of these fails the command. `cargo xtask test` checks that the tests pass
//! without a mutant.
//!
//! What it must not know: the defects, and what the tests test.

pub mod mutant;
pub mod sandbox;
mod seed;
pub mod trial;

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use anstyle::{AnsiColor, Style};
use serde_json::{Value, json};

use crate::args::Mutate;
use crate::error::{Error, Outcome};
use crate::stages::{Progress, Voice};
use mutant::Mutant;
use sandbox::Sandbox;
use trial::Found;

/// All tests of the crates that mutants change, from the cheapest to the most expensive. The tests of `xtask` are
/// omitted: they would only find that a patch does not apply twice. Tests run with the workspace's features where
/// possible, so that packages of the registry are not rebuilt.
const TESTS: [&str; 9] = [
    "test --workspace --test c --test interpret --test passes --test passes_random --test validate",
    "xtask gen --check",
    "test --workspace --test all corpus::",
    "test --workspace --test all linear::",
    "test --workspace --test all edges::",
    "test --workspace --test all random::",
    "test --package bessemer-backend --package bessemer-frontend --package bessemer-codegen --package bessemer-ir --package bessemer-legs --lib --tests",
    "test --package bessemer",
    "test --workspace --test all",
];

const GREEN: Style = Style::new().fg_color(Some(anstyle::Color::Ansi(AnsiColor::Green)));
const RED: Style = Style::new().bold().fg_color(Some(anstyle::Color::Ansi(AnsiColor::Red)));

/// The fate of a mutant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Fate {
    /// A test failed, so the mutant is detected.
    Killed {
        /// The tests that failed.
        by: String,
        /// The command that failed.
        command: String,
    },
    /// A test failed, but not the one in its header.
    Elsewhere {
        /// The tests that failed.
        by: String,
        /// The command that failed.
        command: String,
    },
    /// No test failed.
    Survived,
    /// The changed source does not compile.
    Uncompiled,
    /// The patch does not apply: the message of git.
    Unapplied(String),
    /// A command could not be executed: its message.
    Unrun(String),
}

impl Fate {
    fn verdict(&self) -> &'static str {
        match self {
            Self::Killed { .. } => "killed",
            Self::Elsewhere { .. } => "misnamed",
            Self::Survived => "survived",
            Self::Uncompiled => "not compiled",
            Self::Unapplied(_) => "not applied",
            Self::Unrun(_) => "not run",
        }
    }

    fn detail(&self, mutant: &Mutant) -> String {
        match self {
            Self::Killed { by, command } => killer(by, command),
            Self::Elsewhere { by, command } => format!(
                "by {}, not by cargo {}, as its header says",
                killer(by, command),
                mutant.killed_by.as_deref().unwrap_or_default()
            ),
            Self::Survived => "no test tells: write one that does".to_owned(),
            Self::Uncompiled => "mend the patch".to_owned(),
            Self::Unapplied(said) | Self::Unrun(said) => said.clone(),
        }
    }

    fn is_good(&self) -> bool {
        matches!(self, Self::Killed { .. })
    }
}

/// Tries the requested mutants and prints a line for each.
///
/// # Errors
/// An error that keeps it from trying them; a mutant that survives is an [`Outcome::Bad`].
pub fn run(root: &Path, wanted: &Mutate) -> Result<Outcome, Error> {
    let trials = Trials::of(root, wanted)?;
    let said = |line: &str| {
        if !wanted.json {
            anstream::println!("{line}");
        }
    };
    let fates = trials.run(Share::All, &Progress::default(), &said)?;
    if wanted.json {
        let all = trials.chosen.iter().zip(&fates);
        let entries = all.map(|(mutant, (fate, time))| entry(mutant, fate, *time));
        anstream::println!("{:#}", Value::Array(entries.collect()));
    }
    Ok(if are_found(&fates) { Outcome::Good } else { Outcome::Bad })
}

/// A part of the chosen mutants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Share {
    /// All of them.
    All,
    /// Mutants whose tests need no tree of a package: they may run concurrently with the tests.
    WithoutTrees,
    /// Mutants whose tests need trees. They are tried after the workspace's tests, which build and store these trees;
    /// before, the copy would build them itself and not store them.
    WithTrees,
}

impl Share {
    fn has(self, mutant: &Mutant) -> bool {
        match self {
            Self::All => true,
            Self::WithoutTrees => !mutant.needs_trees(),
            Self::WithTrees => mutant.needs_trees(),
        }
    }
}

/// Fate of each mutant, and the time it took.
pub type Fates = Vec<(Fate, Duration)>;

/// Returns true if a test detected each mutant.
#[must_use]
pub fn are_found(fates: &Fates) -> bool {
    fates.iter().all(|(fate, _)| fate.is_good())
}

/// Mutants, and the copy of the work tree in which they are tried.
#[derive(Debug)]
pub struct Trials {
    root: PathBuf,
    chosen: Vec<Mutant>,
    sandbox: Sandbox,
}

impl Trials {
    /// Returns the trials of the requested mutants. Built registry packages are hard-linked into the copy, so no build
    /// may run meanwhile.
    ///
    /// # Errors
    /// If there is no such mutant, or no copy.
    pub fn of(root: &Path, wanted: &Mutate) -> Result<Trials, Error> {
        let chosen = chosen(Mutant::all(root)?, wanted)?;
        Ok(Trials { root: root.to_owned(), chosen, sandbox: Sandbox::of(root)? })
    }

    /// Tries the mutants of `share` one after another, and prints a line for each.
    ///
    /// # Errors
    ///
    /// An error that prevents trying them.
    pub fn run(
        &self,
        share: Share,
        progress: &Progress,
        said: &dyn Fn(&str),
    ) -> Result<Fates, Error> {
        let width = self.chosen.iter().map(|mutant| mutant.name.len()).max().unwrap_or(0);
        let mut fates = Vec::new();
        for (index, mutant) in self.chosen.iter().enumerate().filter(|(_, it)| share.has(it)) {
            let stage = format!("{}/{} {}", index + 1, self.chosen.len(), mutant.name);
            let start = Instant::now();
            let fate =
                progress.moving(&stage, |voice| fate(&self.root, &self.sandbox, mutant, voice))?;
            said(&line(mutant, &fate, start.elapsed(), width));
            fates.push((fate, start.elapsed()));
        }
        self.sandbox.restore()?;
        Ok(fates)
    }
}

/// Returns the mutants that the command line names.
fn chosen(all: Vec<Mutant>, wanted: &Mutate) -> Result<Vec<Mutant>, Error> {
    if let Some(name) = wanted.names.iter().find(|name| all.iter().all(|it| it.name != **name)) {
        let known = all.into_iter().map(|it| it.name).collect();
        return Err(Error::NoMutant { name: name.clone(), known });
    }
    Ok(match (wanted.turn, wanted.of) {
        (Some(turn), Some(of)) if turn > of => {
            return Err(Error::NoTurn { turn: turn.get(), of: of.get() });
        }
        (Some(turn), Some(of)) => mutant::of_turn(all, turn, of),
        _ if wanted.all => all,
        _ => all.into_iter().filter(|it| wanted.names.contains(&it.name)).collect(),
    })
}

/// Selects up to `count` mutants by a number, such as one derived from a commit, so that runs alternate.
///
/// # Errors
///
/// The mutants cannot be read.
pub fn by_turn(root: &Path, number: u32, count: NonZeroUsize) -> Result<Mutate, Error> {
    let (turn, of) = mutant::turn_of(number, Mutant::all(root)?.len(), count);
    Ok(Mutate { turn: Some(turn), of: Some(of), ..Mutate::default() })
}

/// Tries one mutant.
fn fate(root: &Path, sandbox: &Sandbox, mutant: &Mutant, voice: &Voice) -> Result<Fate, Error> {
    sandbox.restore()?;
    if let Err(said) = sandbox.mutate(mutant)? {
        return Ok(Fate::Unapplied(said));
    }
    let packages = mutant.packages(root);
    for command in mutant.killed_by.as_deref().into_iter().chain(TESTS) {
        let by = match trial::run(&mut sandbox.cargo(command), voice)? {
            Found::Nothing => continue,
            Found::Broken(package) if packages.contains(&package) => return Ok(Fate::Uncompiled),
            Found::Broken(package) => format!("the build of {package}"),
            Found::Test(name) => name,
            Found::Failure => String::new(),
            Found::Unrun(said) => return Ok(Fate::Unrun(format!("cargo {command}: {said}"))),
            Found::Silence => "a test that does not end".to_owned(),
        };
        let command = command.to_owned();
        return Ok(match &mutant.killed_by {
            Some(stated) if *stated != command => Fate::Elsewhere { by, command },
            _ => Fate::Killed { by, command },
        });
    }
    Ok(Fate::Survived)
}

/// Names the test that failed, and the command if it names none.
fn killer(by: &str, command: &str) -> String {
    if by.is_empty() { format!("cargo {command}") } else { format!("{by} of cargo {command}") }
}

fn line(mutant: &Mutant, fate: &Fate, time: Duration, width: usize) -> String {
    let style = if fate.is_good() { GREEN } else { RED };
    let (name, verdict, detail) = (&mutant.name, fate.verdict(), fate.detail(mutant));
    let seconds = time.as_secs_f64();
    format!("{name:width$}  {style}{verdict:12}{style:#}  {seconds:>7.1} s  {detail}")
}

fn entry(mutant: &Mutant, fate: &Fate, time: Duration) -> Value {
    let (by, command) = match fate {
        Fate::Killed { by, command } | Fate::Elsewhere { by, command } => {
            (Some(by).filter(|by| !by.is_empty()), Some(format!("cargo {command}")))
        }
        _ => (None, None),
    };
    json!({
        "mutant": mutant.name,
        "what": mutant.what,
        "changed": mutant.changed,
        "verdict": fate.verdict(),
        "killed_by": by,
        "command": command,
        "seconds": time.as_secs_f64(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mutant(name: &str) -> Mutant {
        let text = "It is broken.\nkilled-by: cargo test -p it\n--- a/x\n+++ b/x\n";
        Mutant::parse(Path::new(&format!("{name}.patch")), text).expect("it is whole")
    }

    #[test]
    fn the_command_line_chooses() {
        let all = || ["a", "b", "c"].map(mutant).to_vec();
        let names = |wanted: Mutate| {
            let chosen = chosen(all(), &wanted);
            chosen.map(|all| all.into_iter().map(|it| it.name).collect::<Vec<_>>())
        };
        let named = Mutate { names: vec!["c".to_owned(), "a".to_owned()], ..Mutate::default() };
        assert!(names(named).is_ok_and(|names| names == ["a", "c"]));
        let every = Mutate { all: true, ..Mutate::default() };
        assert!(names(every).is_ok_and(|names| names == ["a", "b", "c"]));
        let second =
            Mutate { turn: NonZeroUsize::new(2), of: NonZeroUsize::new(2), ..Mutate::default() };
        assert!(names(second).is_ok_and(|names| names == ["b"]));
        let third =
            Mutate { turn: NonZeroUsize::new(3), of: NonZeroUsize::new(2), ..Mutate::default() };
        assert!(matches!(names(third), Err(Error::NoTurn { turn: 3, of: 2 })));
        let unknown = Mutate { names: vec!["d".to_owned()], ..Mutate::default() };
        assert!(matches!(names(unknown), Err(Error::NoMutant { name, .. }) if name == "d"));
    }

    #[test]
    fn the_shares_have_each_mutant_once() {
        let of = |command: &str| Mutant { killed_by: Some(command.to_owned()), ..mutant("a") };
        let all = ["test --workspace --test all corpus::", "test -p it --lib"].map(of);
        for (mutant, needs) in all.iter().zip([true, false]) {
            assert_eq!(Share::WithTrees.has(mutant), needs);
            assert_eq!(Share::WithoutTrees.has(mutant), !needs);
            assert!(Share::All.has(mutant));
        }
    }

    #[test]
    fn a_line_for_each() {
        let plain = |fate: &Fate| {
            let time = Duration::from_millis(12_345);
            anstream::adapter::strip_str(&line(&mutant("order"), fate, time, 8)).to_string()
        };
        let (by, command) = ("corpus::a".to_owned(), "test -p it".to_owned());
        let killed = Fate::Killed { by: by.clone(), command: command.clone() };
        assert_eq!(
            plain(&killed),
            "order     killed           12.3 s  corpus::a of cargo test -p it"
        );
        assert!(killed.is_good());
        let bad = [
            Fate::Elsewhere { by, command },
            Fate::Survived,
            Fate::Uncompiled,
            Fate::Unapplied("error: patch failed".to_owned()),
            Fate::Unrun("error: no such package".to_owned()),
        ];
        assert!(bad.iter().all(|fate| !fate.is_good()));
        assert!(plain(&bad[0]).contains("misnamed"), "{}", plain(&bad[0]));
        assert_eq!(
            plain(&bad[1]),
            "order     survived         12.3 s  no test tells: write one that does"
        );
        let entry = entry(&mutant("order"), &killed, Duration::from_millis(1_500));
        assert_eq!(entry["verdict"], "killed");
        assert_eq!(entry["killed_by"], "corpus::a");
        assert_eq!(entry["seconds"], 1.5);
    }
}
