//! Mistakes of newcomers. Each file of `tests/newcomers/` is a module with one; its first line has its author's
//! intention, and its snapshot is the output of `cargo xtask gen`.
//!
//! All of them are in one package. rustc and the generator tell everything that they find in a step; the modules
//! that are reported are taken out, and what is left is generated again, until it becomes C: then the warnings are
//! told. So a step costs as much as one model, and no mistake hides another.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use bessemer_codegen::generate::Error;
use bessemer_frontend::diagnostic::{self, Diagnostic, Level};
use bessemer_frontend::source::Sources;
use bessemer_tests::turn;
use bessemer_tests::workspace::Workspace;

/// Number of mistakes in a run.
const AT_ONCE: usize = 40;

/// Number of those that follow a remedy.
const FOLLOWED_AT_ONCE: usize = 10;

/// Names that no author has written.
const INTERNAL: [&str; 4] = ["__", "dsl_", "ScalarType", "bessemer::generate"];

/// Item that always becomes C: without it, the last mistake may leave none.
const BESIDE: &str = "#[bessemer::function]\npub fn same(x: f64) -> f64 {\n    x\n}\n";

#[test]
fn each_is_told_at_its_line() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("newcomers");
    let mut untold = turn::some_of(names_in(&folder, "rs"), AT_ONCE);
    let workspace = Workspace::with_source("").expect("a workspace");
    copy(&untold, &folder, &workspace);
    let sources = Sources::new(workspace.path(""));
    let mut internals = Vec::new();
    while !untold.is_empty() {
        let (told, is_last) = step(&workspace, &untold);
        for (name, told) in &told {
            let said = alike_in_each_turn(name, &diagnostic::render(told, &sources, false));
            told.iter().for_each(|it| an_editor_finds(it, &workspace, &sources));
            let shown = INTERNAL.iter().filter(|it| said.contains(*it));
            internals.extend(shown.map(|it| format!("{name}: {it}")));
            insta::with_settings!({ prepend_module_to_snapshot => false, snapshot_path => "../newcomers", omit_expression => true }, {
                insta::assert_snapshot!(name.as_str(), said);
            });
        }
        let before = untold.len();
        untold.retain(|name| !told.contains_key(name));
        assert!(untold.is_empty() || !is_last, "nothing is told of {untold:?}");
        assert!(untold.len() < before, "what is told has no place");
    }
    assert!(internals.is_empty(), "names of the tool's own show: {internals:#?}");
}

/// Removes what depends on the other mistakes of a subset.
///
/// rustc remarks that a lint is on by default beside the first error of a kind in a build, and writes the module of a
/// type if another module has a type of this name.
fn alike_in_each_turn(module: &str, said: &str) -> String {
    let said = said.replace(&format!("{module}::"), "");
    let mut lines: Vec<&str> = Vec::new();
    for line in said.lines() {
        if line.trim_start().starts_with("= note: `#[") && line.ends_with("on by default") {
            lines.pop_if(|before| before.trim() == "|");
        } else {
            lines.push(line);
        }
    }
    lines.join("\n")
}

/// Each `newcomers/followed/*.patch` does what the `help:` of its mistake says. Then nothing is reported any more.
#[test]
fn remedies_work_when_they_are_followed() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("newcomers");
    let patches = folder.join("followed");
    let names = turn::some_of(names_in(&patches, "patch"), FOLLOWED_AT_ONCE);
    let workspace = Workspace::with_source("").expect("a workspace");
    copy(&names, &folder, &workspace);
    for name in &names {
        follow(&patches.join(format!("{name}.patch")), &workspace);
    }
    let (told, is_last) = step(&workspace, &names);
    let said: Vec<Diagnostic> = told.into_values().flatten().collect();
    let said = diagnostic::render(&said, &Sources::new(workspace.path("")), false);
    assert!(is_last && said.is_empty(), "{said}");
}

/// Applies a patch to the copied mistake.
fn follow(patch: &Path, workspace: &Workspace) {
    let folder = workspace.folder().join("src");
    let mut git = Command::new("git");
    // A repository above would make git skip files that are not below this folder.
    let above = folder.parent().unwrap_or(&folder);
    git.args(["apply", "--whitespace=nowarn"]).arg(patch);
    git.current_dir(&folder).env("GIT_CEILING_DIRECTORIES", above);
    let output = git.output().expect("git");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Returns the names of the files of a folder with this extension, sorted.
fn names_in(folder: &Path, extension: &str) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the mistakes").flatten().map(|entry| entry.path());
    let mut names: Vec<String> = entries
        .filter(|path| path.extension().is_some_and(|it| it == extension))
        .map(|path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

fn copy(names: &[String], folder: &Path, workspace: &Workspace) {
    for name in names {
        let file = format!("{name}.rs");
        fs::copy(folder.join(&file), workspace.folder().join("src").join(file)).expect("a module");
    }
}

/// Returns the diagnostics of each module, and true if they became C.
pub(super) fn step(
    workspace: &Workspace,
    names: &[String],
) -> (BTreeMap<String, Vec<Diagnostic>>, bool) {
    let modules: String = names.iter().map(|name| format!("pub mod {name};\n")).collect();
    workspace
        .set_source(&format!("//! Mistakes.\n#![allow(missing_docs)]\n{modules}{BESIDE}"))
        .expect("a source file");
    let (all, is_last) = match workspace.perform(&workspace.job()) {
        Ok(summary) => (summary.remarks.diagnostics, true),
        Err(Error::Models(told) | Error::Refused(told)) => {
            assert!(!told.diagnostics.is_empty(), "{told}");
            (told.diagnostics, false)
        }
        Err(other) => panic!("{other}"),
    };
    let mut told = BTreeMap::<String, Vec<Diagnostic>>::new();
    for one in all.into_iter().filter(|it| is_last || it.level == Level::Error) {
        let name = one.file.rsplit('/').next().and_then(|file| file.strip_suffix(".rs"));
        let name = name.filter(|name| names.iter().any(|it| it == name));
        let name = name
            .unwrap_or_else(|| panic!("{}: {} is no place in a mistake", one.message, one.file));
        told.entry(name.to_owned()).or_default().push(one);
    }
    (told, is_last)
}

/// Checks that a diagnostic for editors is equal and at the same place, by lines and by bytes.
fn an_editor_finds(told: &Diagnostic, workspace: &Workspace, sources: &Sources) {
    let json = diagnostic::json(told, sources);
    assert_eq!(json["level"], told.level.word(), "{json}");
    assert!(json["message"].as_str().is_some_and(|it| !it.is_empty()), "{json}");
    assert!(json["rendered"].as_str().is_some_and(|it| it.contains("-->")), "{json}");
    if told.rustc.is_some() {
        // As rustc wrote it.
        return;
    }
    let spans = json["spans"].as_array().expect("spans");
    let span = spans.iter().find(|span| span["is_primary"] == true).expect("a primary span");
    let text = fs::read_to_string(workspace.path(&told.file)).expect("the file");
    let number = |key: &str| span[key].as_u64().expect("a number") as usize;
    let marked = &text[number("byte_start")..number("byte_end")];
    let before = &text[..number("byte_start")];
    assert_eq!(before.matches('\n').count() + 1, number("line_start"), "{json}");
    let line = &span["text"][0];
    let column = |key: &str| line[key].as_u64().expect("a column") as usize - 1;
    let shown: String = line["text"].as_str().expect("a line").chars().collect::<Vec<_>>()
        [column("highlight_start")..column("highlight_end")]
        .iter()
        .collect();
    assert_eq!(marked.lines().next().unwrap_or_default(), shown, "{json}");
}
