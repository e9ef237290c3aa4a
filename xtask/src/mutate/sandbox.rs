//! The copy of the work tree in which mutants are tried, and the target folder that they share.
//!
//! Invariants:
//! - the work tree itself is never changed;
//! - a file of the copy is written only where it differs, so that cargo builds anew what a mutant changes, what the last one
//!   changed, and what rests on these; it is as old as the one of the work tree only where the builds are that one's, too;
//! - one run at a time has the copy.
//!
//! The copy always lies in the same place: cargo would build every package of another place anew.

use std::collections::BTreeSet;
use std::fs::{self, File, TryLockError};
use std::path::{Path, PathBuf};
use std::process::Command;

use super::mutant::{self, Mutant};
use super::seed;
use crate::error::Error;
use crate::project;

/// A copy of the work tree at `root`.
#[derive(Debug)]
pub struct Sandbox {
    root: PathBuf,
    /// Folder of the copy.
    pub tree: PathBuf,
    target: PathBuf,
    _lock: File,
}

impl Sandbox {
    /// Opens the copy of the work tree at `root`.
    ///
    /// # Errors
    ///
    /// [`Error::Busy`] if another run uses it; the message of the file system.
    pub fn of(root: &Path) -> Result<Sandbox, Error> {
        let folder = root.join("target/mutants");
        let tree = folder.join("tree");
        fs::create_dir_all(&tree).map_err(of(&tree))?;
        let path = folder.join("lock");
        let lock = File::create(&path).map_err(of(&path))?;
        lock.try_lock().map_err(|error| match error {
            TryLockError::WouldBlock => Error::Busy { folder: folder.clone() },
            TryLockError::Error(source) => Error::File { path, source },
        })?;
        let target = folder.join("target");
        let sandbox = Sandbox { root: root.to_owned(), tree, target, _lock: lock };
        if seed::seed(root, &sandbox.target).map_err(of(&sandbox.target))? {
            fs::remove_dir_all(&sandbox.tree).map_err(of(&sandbox.tree))?;
            sandbox.restore()?;
            sandbox.age()?;
        }
        Ok(sandbox)
    }

    /// Makes the copy equal to the present work tree, with uncommitted changes.
    ///
    /// # Errors
    ///
    /// An error of git or of the file system.
    pub fn restore(&self) -> Result<(), Error> {
        let wanted = listed(&self.root)?;
        for name in &wanted {
            let (from, to) = (self.root.join(name), self.tree.join(name));
            if fs::read(&from).map_err(of(&from))? == fs::read(&to).unwrap_or_default()
                && to.exists()
            {
                continue;
            }
            if let Some(folder) = to.parent() {
                fs::create_dir_all(folder).map_err(of(folder))?;
            }
            fs::copy(&from, &to).map_err(of(&to))?;
        }
        self.sweep(&self.tree, &wanted)
    }

    /// Gives each file and folder of the copy the time stamp of the original.
    fn age(&self) -> Result<(), Error> {
        let listed = listed(&self.root)?;
        let all: BTreeSet<&Path> = listed.iter().flat_map(|name| name.ancestors()).collect();
        for name in all {
            let (from, to) = (self.root.join(name), self.tree.join(name));
            seed::age(&from, &to).map_err(of(&to))?;
        }
        Ok(())
    }

    /// Removes files of the copy that the work tree does not have.
    fn sweep(&self, folder: &Path, wanted: &BTreeSet<PathBuf>) -> Result<(), Error> {
        for entry in fs::read_dir(folder).map_err(of(folder))? {
            let path = entry.map_err(of(folder))?.path();
            if path.is_dir() && !path.is_symlink() {
                self.sweep(&path, wanted)?;
            } else if path.strip_prefix(&self.tree).is_ok_and(|name| !wanted.contains(name)) {
                fs::remove_file(&path).map_err(of(&path))?;
            }
        }
        Ok(())
    }

    /// Applies the mutant's patch to the copy; returns git's message if it does not apply.
    ///
    /// # Errors
    ///
    /// Git does not run.
    pub fn mutate(&self, mutant: &Mutant) -> Result<Result<(), String>, Error> {
        let output = run(&mut mutant::git_apply(&self.tree, &mutant.patch))?;
        let said = String::from_utf8_lossy(&output.stderr).trim().to_owned();
        Ok(if output.status.success() { Ok(()) } else { Err(said) })
    }

    /// Returns a cargo command in the copy, with the words of `command`.
    #[must_use]
    pub fn cargo(&self, command: &str) -> Command {
        let mut words: Vec<&str> = command.split_whitespace().collect();
        let package = words.get(2).filter(|_| words.get(1) == Some(&"-p"));
        // A package's own tests run once, which takes less time than to optimise it.
        let plain = package.map(|it| format!("profile.dev.package.{it}.opt-level=0"));
        if let Some(plain) = &plain {
            words.splice(1..1, project::UNIFIED.into_iter().chain(["--config", plain]));
        }
        let mut cargo = project::cargo(&self.tree, &words);
        // A snapshot that differs is a failure; nobody accepts it there.
        cargo.env("CARGO_TARGET_DIR", &self.target).env("INSTA_UPDATE", "no");
        // As the tests are built, whose builds are here.
        project::lint(&mut cargo);
        // Most mutants leave the trees of the tests' packages as they are, each a build of minutes.
        cargo.env("BESSEMER_STORE", self.root.join("target"));
        cargo
    }
}

/// Lists the files of the work tree that git tracks or would add.
fn listed(root: &Path) -> Result<BTreeSet<PathBuf>, Error> {
    let mut git = Command::new("git");
    git.args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"]).current_dir(root);
    let output = run(&mut git)?;
    if !output.status.success() {
        let said = String::from_utf8_lossy(&output.stderr).trim().to_owned();
        return Err(Error::NoCheckout { said });
    }
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    // What is removed and not yet committed is still listed.
    let there = |name: &PathBuf| root.join(name).is_file();
    Ok(text.split_terminator('\0').map(PathBuf::from).filter(there).collect())
}

fn run(command: &mut Command) -> Result<std::process::Output, Error> {
    command.output().map_err(|source| Error::Spawn { program: "git".to_owned(), source })
}

fn of(path: &Path) -> impl FnOnce(std::io::Error) -> Error + use<> {
    let path = path.to_owned();
    |source| Error::File { path, source }
}
