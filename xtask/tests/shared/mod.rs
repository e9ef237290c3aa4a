//! The text files of the repository, for tests that hold all of them to something.

#![allow(dead_code, reason = "not every test needs all of it")]

use std::path::{Path, PathBuf};
use std::process::Command;

/// A file of the repository: its path from the root, with `/`, and its text.
pub struct File {
    pub path: String,
    pub text: String,
}

impl File {
    pub fn is_rust(&self) -> bool {
        self.path.ends_with(".rs") && !self.path.starts_with("generated/")
    }

    /// Returns true for a crate's own code; false for tests, examples and benchmarks.
    pub fn is_source(&self) -> bool {
        self.is_rust() && self.path.split('/').any(|folder| folder == "src")
    }
}

pub fn root() -> PathBuf {
    xtask::project::root()
}

/// The text files of the repository, those not yet added included.
pub fn files() -> Vec<File> {
    let root = root();
    let paths = listed(&root).unwrap_or_else(|| walked(&root));
    let read = |path: String| {
        std::fs::read_to_string(root.join(&path)).ok().map(|text| File { path, text })
    };
    let files: Vec<File> = paths.into_iter().filter_map(read).collect();
    assert!(
        files.iter().any(|file| file.path == "xtask/tests/tidy.rs"),
        "the files were not found"
    );
    files
}

/// Returns the paths that git knows or would add; none outside a git checkout.
fn listed(root: &Path) -> Option<Vec<String>> {
    let arguments = ["ls-files", "-z", "--cached", "--others", "--exclude-standard"];
    let output = Command::new("git").args(arguments).current_dir(root).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    output.status.success().then(|| text.split_terminator('\0').map(str::to_owned).collect())
}

/// Every file below `root`, for a source archive without git: build products and hidden state aside.
fn walked(root: &Path) -> Vec<String> {
    let (mut found, mut folders) = (Vec::new(), vec![root.to_owned()]);
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(&folder).into_iter().flatten().flatten() {
            let (path, name) = (entry.path(), entry.file_name());
            if path.is_dir() {
                if name != "target" && name != ".git" {
                    folders.push(path);
                }
            } else if let Ok(path) = path.strip_prefix(root) {
                found.push(path.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    found
}

/// Fails with every offence against a rule.
#[track_caller]
pub fn none(rule: &str, offences: &[String]) {
    assert!(offences.is_empty(), "{rule}:\n  {}\n", offences.join("\n  "));
}
