//! Programs that the DSL does not take: each file of `tests/refused/` must not compile, and its snapshot is
//! what rustc tells its author.
//!
//! Drop a file there and get a test. `INSTA_UPDATE=always cargo test -p bessemer-tests refused::` writes the snapshots anew:
//! read them as the author of the program would.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use bessemer_tests::workspace::Workspace;
use serde_json::Value;

#[test]
fn refused_programs_are_told_why() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("refused");
    let entries = fs::read_dir(folder).expect("the cases").flatten().map(|entry| entry.path());
    let cases = entries.filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    let workspace = Workspace::with_source("//! No model.\n").expect("a workspace");
    let programs = workspace.folder().join("src/bin");
    let mut names = Vec::new();
    for case in cases {
        fs::copy(&case, programs.join(case.file_name().unwrap_or_default())).expect("a program");
        names.push(case.file_stem().unwrap_or_default().to_string_lossy().into_owned());
    }
    let said = told(&workspace);
    for name in names {
        let said = said.get(&name).unwrap_or_else(|| panic!("{name} compiles"));
        insta::with_settings!({ prepend_module_to_snapshot => false, snapshot_path => "../refused", omit_expression => true }, {
            insta::assert_snapshot!(name, said);
        });
    }
}

/// Refusals that no snapshot tells, which only become fewer: one of a rustc that does not exist yet.
const UNTOLD: [&str; 1] = ["HYGIENE_UNKNOWN"];

/// Whoever adds a refusal shows what its author is reported.
#[test]
fn each_refusal_is_in_a_snapshot() {
    let tests = PathBuf::from(env!("CARGO_MANIFEST_DIR"));
    let folders = ["refused", "diagnosed", "newcomers"].map(|folder| tests.join(folder));
    let files = folders.into_iter().flat_map(|folder| fs::read_dir(folder).expect("the cases"));
    let snapshots = files.flatten().map(|entry| entry.path());
    let told: String = snapshots
        .filter(|path| path.extension().is_some_and(|extension| extension == "snap"))
        .map(|path| fs::read_to_string(path).expect("a snapshot"))
        .collect();
    let refusals = tests.join("../dsl/macros/src/lower/refuse.rs");
    let refusals = fs::read_to_string(refusals).expect("the refusals");
    let (_, listed) = refusals.split_once("\nreasons! {\n").expect("the list");
    let (listed, _) = listed.split_once("\n}").expect("its end");
    let untold: Vec<&str> = listed
        .lines()
        .filter_map(|line| {
            let (name, rest) = line.trim().split_once(": \"")?;
            let (what, _) = rest.split_once("\", \"")?;
            (!told.contains(&what.replace("\\\"", "\""))).then_some(name)
        })
        .collect();
    assert_eq!(untold, UNTOLD, "write a program that gets it into `tests/refused/`");
}

/// Returns rustc's errors for each program that does not compile.
fn told(workspace: &Workspace) -> BTreeMap<String, String> {
    let _alone = workspace.alone().expect("the target folder");
    let output = Command::new(env!("CARGO"))
        .args(["build", "--bins", "--keep-going", "--message-format=json"])
        .current_dir(workspace.path(""))
        .output()
        .expect("cargo");
    let mut told = BTreeMap::<String, String>::new();
    for line in String::from_utf8_lossy(&output.stdout).lines() {
        let Ok(line) = serde_json::from_str::<Value>(line) else { continue };
        let message = &line["message"];
        let title = message["message"].as_str().unwrap_or_default();
        let [name, rendered] = [&line["target"]["name"], &message["rendered"]].map(Value::as_str);
        let (Some(name), Some(rendered)) = (name, rendered) else { continue };
        let one = unnumbered(rendered);
        let told = told.entry(name.to_owned()).or_default();
        // The last error of each program counts the others.
        if message["level"] == "error"
            && !title.starts_with("aborting due to")
            && !told.contains(&one)
        {
            told.push_str(&one);
        }
    }
    told
}

/// Without the numbers of the DSL's own lines, which move.
fn unnumbered(rendered: &str) -> String {
    let mut text = String::new();
    let mut in_dsl = false;
    for line in rendered.lines() {
        in_dsl = line.contains(" dsl/src/")
            || in_dsl && !line.trim().is_empty() && !line.contains("--> ");
        let line = match line.split_once(" dsl/src/") {
            Some((arrow, path)) => {
                format!("{arrow} dsl/src/{}", path.split(':').next().unwrap_or_default())
            }
            None if in_dsl => {
                let rest = line.trim_start_matches(|it: char| it.is_ascii_digit());
                " ".repeat(line.len() - rest.len()) + rest
            }
            None => line.to_owned(),
        };
        text.push_str(&line);
        text.push('\n');
    }
    text
}
