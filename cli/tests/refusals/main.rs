//! Mistakes of users through the command itself. Each ends with an error and, where known, a remedy; files are
//! unchanged.
//!
//! None of them gets as far as a build, so that a hundred take seconds. What rustc or the compiler says of models is in
//! `tests/refused/`, `tests/diagnosed/` and `tests/newcomers/`; a full disk, a kill and two runs at once are in `interrupted.rs`.

mod settings;
mod traces;
mod workspaces;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use tempfile::TempDir;

use crate::settings::{NAMES, SETTINGS};
use crate::workspaces::{CASES, PACKAGE};

/// A file of the workspace: its path and its text. A path that ends with `/` is a folder; one that ends with `@` is a
/// link to the text.
type File = (&'static str, &'static str);

struct Case<'a> {
    name: &'a str,
    files: &'a [File],
    /// The words behind `cargo bessemer`.
    words: &'a [&'a str],
    /// Current folder of the user.
    folder: &'a str,
    /// True if only cargo and rustc are found.
    bare: bool,
    /// The place that it is reported at, if it is one.
    place: &'a str,
    said: &'a str,
    remedy: &'a str,
}

/// A case with nothing of its own.
const PLAIN: Case<'static> = Case {
    name: "",
    files: &[],
    words: &["gen"],
    folder: "",
    bare: false,
    place: "",
    said: "",
    remedy: "",
};

/// The C of the generation before, where a case has nothing of its own there.
const BEFORE: &[File] = &[
    (
        "generated/manifest.json",
        "{ \"package\": \"motor\", \"files\": [\"motor.c\", \"motor.h\"] }",
    ),
    ("generated/motor.c", "#include \"motor.h\"\n"),
    ("generated/motor.h", "#define MOTOR_H\n"),
];

fn laid_out(files: &[File]) -> TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let own = files.iter().any(|(path, _)| path.starts_with("generated"));
    for (name, text) in files.iter().chain(BEFORE.iter().filter(|_| !own)) {
        let path = folder.path().join(name.trim_end_matches('@'));
        let parent = if name.ends_with('/') { Some(&*path) } else { path.parent() };
        fs::create_dir_all(parent.expect("it is in the folder")).expect("a folder");
        if name.ends_with('@') {
            std::os::unix::fs::symlink(text, path).expect("a link");
        } else if !name.ends_with('/') {
            fs::write(path, text).expect("a file");
        }
    }
    folder
}

/// Each file and link with its content, each folder with none; cargo's own apart.
fn tree(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut all = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("a folder").flatten() {
        let (path, name) = (entry.path(), entry.file_name().to_string_lossy().into_owned());
        if matches!(name.as_str(), "target" | "Cargo.lock") {
            continue;
        }
        if let Ok(to) = fs::read_link(&path) {
            all.insert(name, to.to_string_lossy().into_owned().into_bytes());
        } else if path.is_dir() {
            all.extend(tree(&path).into_iter().map(|(below, it)| (format!("{name}/{below}"), it)));
            all.insert(name, Vec::new());
        } else {
            all.insert(name, fs::read(&path).expect("a file"));
        }
    }
    all
}

/// Carries out a command in a workspace; what is wrong with how it is refused, if anything is.
fn accepted(files: &[File], case: &Case<'_>) -> Option<String> {
    let workspace = laid_out(files);
    let before = tree(workspace.path());
    let mut command = Command::new(env!("CARGO_BIN_EXE_cargo-bessemer"));
    command.arg("bessemer").args(case.words).current_dir(workspace.path().join(case.folder));
    command.env("CARGO", env!("CARGO")).env_remove("BESSEMER_LEGS").stdin(Stdio::null());
    if case.bare {
        command.env("PATH", workspace.path());
    }
    let output = command.output().expect("it runs");
    let text = String::from_utf8_lossy(&output.stderr);
    // 1 is the command's own, 2 that of words that it does not take; a panic has another.
    let refused = matches!(output.status.code(), Some(1 | 2));
    let told = ["error: ", case.said, case.place, case.remedy].iter().all(|it| text.contains(it));
    let raw = ["\\n", "Error::", "panicked"].iter().any(|it| text.contains(it));
    let same = tree(workspace.path()) == before;
    let good = refused && told && !raw && same;
    let written = if same { "" } else { "\nsomething was written" };
    (!good).then(|| format!("{}: {}\n{text}{written}\n", case.name, output.status))
}

#[test]
fn each_mistake_is_told_with_what_to_do_and_changes_nothing() {
    assert!(CASES.len() + SETTINGS.len() + NAMES.len() >= 100);
    let cases = CASES.iter().chain(traces::CASES).map(|case| accepted(case.files, case));
    let settings = SETTINGS.iter().map(|(text, line, column, said, remedy)| {
        let files = [PACKAGE, &[("bessemer.toml", text)]].concat();
        let place = format!(" --> bessemer.toml:{line}:{column}\n");
        accepted(&files, &Case { name: text, said, remedy, place: &place, ..PLAIN })
    });
    let names = NAMES.iter().map(|name| {
        let said = format!("a package cannot be called `{name}`: ");
        let words = ["new", name];
        let remedy = "choose another";
        accepted(PACKAGE, &Case { name, words: &words, said: &said, remedy, ..PLAIN })
    });
    let wrong: Vec<String> = cases.chain(settings).chain(names).flatten().collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
