//! A mutant: a patch in `tests/mutants/` that introduces one defect into the compiler, with a header.
//!
//! `git apply` accepts the file. Before the first `diff` there is a line that describes the defect and, if it is
//! known, the command that detects it: `killed-by: cargo test …` or `killed-by: cargo xtask gen --check`. Other lines
//! there are free text.
//!
//! What it must not know: how a mutant is tried.

use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::error::Error;

/// Folder of the patches, from the root of the project.
pub const FOLDER: &str = "tests/mutants";

const KILLED_BY: &str = "killed-by:";

/// A patch and the content of its header.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Mutant {
    /// Name of the file without its ending: the area, then the defect.
    pub name: String,
    /// Path of the file.
    pub patch: PathBuf,
    /// A sentence that describes the defect.
    pub what: String,
    /// The command that detects it, without `cargo`; `None` if all tests are to be tried.
    pub killed_by: Option<String>,
    /// The changed files, relative to the root of the project.
    pub changed: Vec<String>,
}

impl Mutant {
    /// Returns every mutant of the project, by name.
    ///
    /// # Errors
    ///
    /// An error of the file system; [`Error::Mutant`] for a file without a valid header.
    pub fn all(root: &Path) -> Result<Vec<Mutant>, Error> {
        let folder = root.join(FOLDER);
        let failed = |source| Error::File { path: folder.clone(), source };
        let mut mutants = Vec::new();
        for entry in std::fs::read_dir(&folder).map_err(failed)? {
            let path = entry.map_err(failed)?.path();
            if path.extension().is_some_and(|ending| ending == "patch") {
                mutants.push(Mutant::read(path)?);
            }
        }
        mutants.sort_by(|a, b| a.name.cmp(&b.name));
        Ok(mutants)
    }

    fn read(patch: PathBuf) -> Result<Mutant, Error> {
        let text = std::fs::read_to_string(&patch)
            .map_err(|source| Error::File { path: patch.clone(), source })?;
        Mutant::parse(&patch, &text)
            .map_err(|problem| Error::Mutant { file: patch.clone(), problem })
    }

    /// Parses the text of a mutant's file.
    ///
    /// # Errors
    ///
    /// The mistake in the text, and a remedy.
    pub fn parse(patch: &Path, text: &str) -> Result<Mutant, String> {
        let header = |line: &&str| !line.starts_with("diff ") && !line.starts_with("--- ");
        let what = text.lines().take_while(header).next().unwrap_or_default().trim();
        if what.is_empty() || what.starts_with(KILLED_BY) {
            return Err("its first line says what is broken, in a sentence".to_owned());
        }
        let said = text.lines().take_while(header).find_map(|line| line.strip_prefix(KILLED_BY));
        let killed_by = said.map(command).transpose()?;
        let changed: Vec<String> = text
            .lines()
            .filter_map(|line| line.strip_prefix("+++ b/"))
            .map(str::to_owned)
            .collect();
        if changed.is_empty() {
            return Err(
                "it changes no file: write the output of `git diff` below the header".to_owned()
            );
        }
        let name = patch.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Ok(Mutant { name, patch: patch.to_owned(), what: what.to_owned(), killed_by, changed })
    }

    /// Returns true if the test that detects it compiles the tests' packages.
    #[must_use]
    pub fn needs_trees(&self) -> bool {
        self.killed_by.as_ref().is_some_and(|command| command.contains("--test all"))
    }

    /// Returns the packages whose sources the mutant changes, by the names in their manifests.
    #[must_use]
    pub fn packages(&self, root: &Path) -> Vec<String> {
        let mut packages: Vec<String> =
            self.changed.iter().filter_map(|file| package(root, Path::new(file))).collect();
        packages.dedup();
        packages
    }
}

/// Returns the command in a header, without `cargo`.
fn command(said: &str) -> Result<String, String> {
    let words = said.split_whitespace().collect::<Vec<_>>().join(" ");
    match words.strip_prefix("cargo ") {
        Some(rest) if rest.starts_with("test ") || rest == "xtask gen --check" => {
            Ok(rest.to_owned())
        }
        _ => Err(format!(
            "`{words}` is no test: write `{KILLED_BY} cargo test …` or `{KILLED_BY} cargo xtask gen --check`"
        )),
    }
}

/// Returns the package that a file belongs to: its nearest parent folder with a manifest.
fn package(root: &Path, file: &Path) -> Option<String> {
    file.ancestors().skip(1).find_map(|folder| {
        let manifest = std::fs::read_to_string(root.join(folder).join("Cargo.toml")).ok()?;
        let name = manifest.lines().find_map(|line| line.strip_prefix("name = "))?;
        Some(name.trim_matches('"').to_owned())
    })
}

/// Returns the command that applies a patch to the files in `folder`.
#[must_use]
pub fn git_apply(folder: &Path, patch: &Path) -> Command {
    let mut git = Command::new("git");
    // Within a checkout git would take the paths for those from its root, and pass over what is not below `folder`.
    let above = folder.parent().unwrap_or(folder);
    git.args(["apply", "--whitespace=nowarn"]).arg(patch);
    git.current_dir(folder).env("GIT_CEILING_DIRECTORIES", above);
    git
}

/// Returns the mutants of one turn; each mutant belongs to exactly one. Turns are numbered from 1.
#[must_use]
pub fn of_turn(mutants: Vec<Mutant>, turn: NonZeroUsize, of: NonZeroUsize) -> Vec<Mutant> {
    let mine = |index: usize| index % of == turn.get() - 1;
    mutants.into_iter().enumerate().filter(|(index, _)| mine(*index)).map(|(_, it)| it).collect()
}

/// Returns the turn for a number, and the number of turns, so that each has at most `count` mutants.
#[must_use]
pub fn turn_of(number: u32, mutants: usize, count: NonZeroUsize) -> (NonZeroUsize, NonZeroUsize) {
    let turns = NonZeroUsize::new(mutants.div_ceil(count.get())).unwrap_or(NonZeroUsize::MIN);
    (NonZeroUsize::MIN.saturating_add(number as usize % turns), turns)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> Result<Mutant, String> {
        Mutant::parse(Path::new("tests/mutants/passes_order.patch"), text)
    }

    const DIFF: &str = "diff --git a/codegen/src/lib.rs b/codegen/src/lib.rs
--- a/codegen/src/lib.rs
+++ b/codegen/src/lib.rs
@@ -1 +1 @@
-a
+b
";

    #[test]
    fn a_file_says_what_is_broken_and_what_finds_it() {
        let text = format!("Order is lost.\nkilled-by:  cargo test -p it  order\n\n{DIFF}");
        let mutant = parse(&text).expect("it is whole");
        assert_eq!(
            (mutant.name.as_str(), mutant.what.as_str()),
            ("passes_order", "Order is lost.")
        );
        assert_eq!(mutant.killed_by.as_deref(), Some("test -p it order"));
        assert_eq!(mutant.changed, ["codegen/src/lib.rs"]);
        let silent = parse(&format!("Order is lost.\n{DIFF}")).expect("it is whole");
        assert_eq!(silent.killed_by, None);
        let check = format!("It is.\nkilled-by: cargo xtask gen --check\n{DIFF}");
        assert_eq!(parse(&check).map(|it| it.killed_by), Ok(Some("xtask gen --check".to_owned())));
    }

    #[test]
    fn a_file_that_does_not_is_refused() {
        for text in [DIFF, "", "\n", "killed-by: cargo test\n", "Order is lost.\n"] {
            assert!(parse(text).is_err(), "{text}");
        }
        for command in ["", "cargo", "test -p it", "rm -rf .", "cargo xtask gen"] {
            let refused = parse(&format!("Order is lost.\nkilled-by: {command}\n{DIFF}"));
            assert!(refused.is_err_and(|problem| problem.contains("is no test")), "{command}");
        }
    }

    #[test]
    fn a_file_belongs_to_the_nearest_package() {
        let root = crate::project::root();
        let of = |file: &str| package(&root, Path::new(file));
        assert_eq!(of("codegen/src/lib.rs").as_deref(), Some("bessemer-codegen"));
        assert_eq!(of("dsl/src/math/sin.rs").as_deref(), Some("bessemer"));
        assert_eq!(of("dsl/macros/src/lib.rs").as_deref(), Some("bessemer-macros"));
        assert_eq!(of("README.md"), None);
    }

    fn at_least_one(number: usize) -> NonZeroUsize {
        NonZeroUsize::new(number).expect("it is not zero")
    }

    #[test]
    fn every_mutant_has_one_turn() {
        let mutants: Vec<Mutant> = ["a", "b", "c", "d", "e"]
            .iter()
            .map(|name| {
                let file = format!("{name}.patch");
                Mutant::parse(Path::new(&file), &format!("It.\n{DIFF}")).expect("it is whole")
            })
            .collect();
        let turns: Vec<Vec<Mutant>> = (1..=3)
            .map(|turn| of_turn(mutants.clone(), at_least_one(turn), at_least_one(3)))
            .collect();
        assert!(turns.iter().all(|turn| (1..=2).contains(&turn.len())));
        let mut all = turns.concat();
        all.sort_by(|a, b| a.name.cmp(&b.name));
        assert_eq!(all, mutants);
    }

    #[test]
    fn every_turn_has_its_number() {
        let turn_of = |number, mutants| {
            let (turn, of) = turn_of(number, mutants, at_least_one(2));
            (turn.get(), of.get())
        };
        assert_eq!(turn_of(7, 5), (2, 3));
        assert_eq!(turn_of(6, 5), (1, 3));
        assert_eq!(turn_of(7, 0), (1, 1));
        let turns: std::collections::BTreeSet<usize> =
            (0..31).map(|number| turn_of(number, 61).0).collect();
        assert_eq!(turns, (1..=31).collect());
    }
}
