//! House rules over the whole repository, which no other tool checks.
//!
//! Each test collects every offence before it fails, so that one run shows them all.

mod shared;

use proc_macro2::{TokenStream, TokenTree};
use serde_json::Value;
use shared::{File, files, none, root};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use xtask::project::UNIFIED;

/// The longest that a Rust file written by hand may be.
const LONGEST: usize = 600;

#[test]
fn no_rust_file_is_long() {
    let length = |file: &File| file.text.lines().count();
    let long = files().into_iter().filter(|file| file.is_rust() && length(file) > LONGEST);
    let offences: Vec<_> =
        long.map(|file| format!("{}: {} lines", file.path, length(&file))).collect();
    none("a Rust file has at most 600 lines; split it", &offences);
}

#[test]
fn every_module_says_what_it_is() {
    let opening = |file: &File| {
        let mut lines = file.text.lines().map(str::trim);
        lines
            .find(|line| !line.is_empty() && !line.starts_with("#!["))
            .unwrap_or_default()
            .to_owned()
    };
    let mute =
        files().into_iter().filter(|file| file.is_source() && !opening(file).starts_with("//!"));
    let offences: Vec<_> = mute.map(|file| file.path).collect();
    none(
        "a source file starts with `//!`: its purpose, its invariants, what it must not know",
        &offences,
    );
}

#[test]
fn no_file_names_a_machine() {
    // In pieces, so that this file does not offend.
    let banned = [["/wo", "rk/"], ["/ro", "ot/"], ["arti", "factory"], ["index.", "crates.io"]]
        .map(|parts| parts.concat());
    let mut offences = Vec::new();
    for file in files().iter().filter(|file| file.path != "Cargo.lock") {
        for (index, line) in file.text.lines().enumerate() {
            let names = banned.iter().filter(|name| line.contains(name.as_str()));
            offences.extend(names.map(|name| format!("{}:{}: {name}", file.path, index + 1)));
        }
    }
    none("no file names a folder of one machine or the host of a registry", &offences);
}

#[test]
fn every_dependency_is_explained() {
    let explained = std::fs::read_to_string(root().join("ARCHITECTURE.md")).expect(
        "ARCHITECTURE.md is missing; it has to say, in `backticks`, why each dependency is there",
    );
    let unexplained =
        dependencies().into_iter().filter(|name| !explained.contains(&format!("`{name}`")));
    none(
        "ARCHITECTURE.md says, in `backticks`, why each dependency is there",
        &unexplained.collect::<Vec<_>>(),
    );
}

/// The names of the dependencies of all members, of every kind, those within the workspace aside.
fn dependencies() -> BTreeSet<String> {
    let packages = packages();
    let all = packages.iter().flat_map(|package| package["dependencies"].as_array());
    let foreign = all.flatten().filter(|dependency| dependency["path"].is_null());
    let names: BTreeSet<_> =
        foreign.filter_map(|dependency| dependency["name"].as_str()).map(str::to_owned).collect();
    assert!(names.contains("clap"), "the dependencies were not found");
    names
}

/// The members of the workspace, as `cargo metadata` describes them.
fn packages() -> Vec<Value> {
    let arguments = ["metadata", "--no-deps", "--offline", "--format-version", "1"];
    let output = xtask::project::cargo(&root(), &arguments).output().expect("cargo starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let metadata: Value =
        serde_json::from_slice(&output.stdout).expect("cargo metadata prints JSON");
    metadata["packages"].as_array().cloned().expect("a list of packages")
}

/// Cargo builds a package once for each set of features. `xtask/unified/Cargo.toml` requests what the tests request, so
/// that the compiler, and all below it, is built once for both; and what depends on it in part: a package whose own test
/// finds a mutant, those whose documentation has examples, and the ground station.
#[test]
fn what_a_part_needs_is_built_once() {
    let of_tests = built(&["--workspace", "--edges", "normal,build,dev"]);
    let mut twice = built(&["--package", "xtask", "--edges", "normal,build"]);
    let tested = packages_that_tell().into_iter().map(|package| vec![package]);
    let tested = tested.chain([packages_with_examples()]);
    let tested = tested.map(|packages| (packages, "normal,build,dev"));
    for (packages, edges) in tested.chain([(vec!["ground".to_owned()], "normal,build")]) {
        let mut part = vec!["--edges", edges];
        part.extend(packages.iter().flat_map(|package| ["--package", package]));
        part.extend(UNIFIED);
        twice.extend(built(&part).into_iter().filter(|it| !it.starts_with("unified ")));
    }
    let twice = twice.difference(&of_tests).cloned().collect::<Vec<_>>();
    none("a part asks for the features that the tests' build has of a package", &twice);
}

/// The packages whose own tests tell of a mutant.
fn packages_that_tell() -> BTreeSet<String> {
    let files = std::fs::read_dir(root().join("tests/mutants")).expect("the mutants").flatten();
    let texts = files.map(|file| std::fs::read_to_string(file.path()).expect("a mutant"));
    let package = |text: String| {
        let (_, command) = text.split_once("killed-by: cargo test -p ")?;
        command.split_whitespace().next().map(str::to_owned)
    };
    texts.filter_map(package).collect()
}

/// Returns the packages whose documentation has examples.
fn packages_with_examples() -> Vec<String> {
    let has = |package: &Value| {
        let targets = package["targets"].as_array().into_iter().flatten();
        targets.into_iter().any(|target| target["doctest"] == true)
    };
    let packages = packages().into_iter().filter(has);
    packages.filter_map(|package| package["name"].as_str().map(str::to_owned)).collect()
}

/// Checks that macros and tests' builds share one set of features for the crates below both, so that cargo builds them
/// once. `cargo tree` does not show dev-dependencies of them.
#[test]
fn what_macros_share_is_built_once() {
    let name = |built: &str| built.split_whitespace().take(2).collect::<Vec<_>>().join(" ");
    let shared =
        built(&["--package", "bessemer", "--package", "bessemer-tree", "--edges", "normal"]);
    let shared: BTreeSet<_> = shared.iter().map(|it| name(it)).collect();
    let mut ways = BTreeMap::<String, Vec<String>>::new();
    for way in built(&["--workspace", "--edges", "normal,build,dev"]) {
        ways.entry(name(&way)).or_default().push(way);
    }
    ways.retain(|name, ways| shared.contains(name) && ways.len() > 1);
    let twice: Vec<_> = ways.into_values().map(|ways| ways.join(" and ")).collect();
    none("what is shared has one set of features in the tests' build", &twice);
}

/// Packages with their features, as a build has them.
fn built(chosen: &[&str]) -> BTreeSet<String> {
    let mut cargo = xtask::project::cargo(&root(), &["tree", "--offline", "--prefix", "none"]);
    let output = cargo.args(["--no-dedupe", "--format", "{p} {f}"]).args(chosen).output();
    let output = output.expect("cargo starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    // A star tells that what a package rests on stood there before.
    let line = |line: &str| line.trim().trim_end_matches("(*)").trim_end().to_owned();
    String::from_utf8_lossy(&output.stdout).lines().map(line).collect()
}

/// Checks that published packages pack: dependencies have versions, and licences and included files are packed. Nothing
/// is built.
#[test]
fn what_is_published_packs() {
    let published: Vec<Value> =
        packages().into_iter().filter(|package| package["publish"].is_null()).collect();
    let name = |package: &Value| package["name"].as_str().unwrap_or_default().to_owned();
    let chosen: Vec<String> =
        published.iter().flat_map(|package| ["--package".to_owned(), name(package)]).collect();
    assert!(chosen.iter().any(|it| it == "cargo-bessemer"), "{chosen:?}");
    let folder = tempfile::tempdir().expect("a folder");
    let packed = |more: &[&str]| {
        let mut cargo = xtask::project::cargo(&root(), &["package", "--offline", "--allow-dirty"]);
        cargo.arg("--target-dir").arg(folder.path()).args(more);
        let output = cargo.output().expect("cargo starts");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success(), "{said}");
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    let mut all = vec!["--no-verify"];
    all.extend(chosen.iter().map(String::as_str));
    packed(&all);

    let mut offences = Vec::new();
    for package in &published {
        let (name, manifest) = (name(package), package["manifest_path"].as_str());
        for key in ["description", "license"] {
            if package[key].as_str().is_none_or(str::is_empty) {
                offences.push(format!("{name}: no {key}"));
            }
        }
        for key in ["keywords", "categories"] {
            if package[key].as_array().is_none_or(Vec::is_empty) {
                offences.push(format!("{name}: no {key}"));
            }
        }
        let list = packed(&["--list", "--package", &name]);
        let files: BTreeSet<&str> = list.lines().collect();
        let licences = ["LICENSE-MIT", "LICENSE-APACHE"].into_iter();
        let lacking = licences.filter(|file| !files.contains(file));
        offences.extend(lacking.map(|file| format!("{name}: no {file}")));
        let folder = Path::new(manifest.unwrap_or_default()).parent().expect("a folder");
        for file in files.iter().filter(|it| it.starts_with("src/") && it.ends_with(".rs")) {
            let text = std::fs::read_to_string(folder.join(file)).expect("it is in the list");
            for included in included(&text) {
                let path = normal(&Path::new(file).parent().expect("a folder").join(included));
                if !files.contains(&*path) {
                    offences.push(format!("{name}: {file} includes {included}"));
                }
            }
        }
    }
    none("a package is published whole", &offences);
}

/// The files that a source includes, its tests aside.
fn included(text: &str) -> Vec<&str> {
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    let parts = text.split("include_str!(\"").chain(text.split("include_bytes!(\"").skip(1));
    parts.skip(1).filter_map(|rest| rest.split('"').next()).collect()
}

/// A path without `..`, as far as it has the folders for it.
fn normal(path: &Path) -> String {
    let mut parts: Vec<&str> = Vec::new();
    for part in path.iter().filter_map(|part| part.to_str()) {
        if part == ".." && parts.last().is_some_and(|last| *last != "..") {
            parts.pop();
        } else {
            parts.push(part);
        }
    }
    parts.join("/")
}

/// Libraries without unit tests say `test = false`, which saves building them twice; none says it that has some.
/// A test that was renamed would be in each run again.
#[test]
fn the_tests_that_alternate_are_there() {
    let sources: String =
        files().iter().filter(|it| it.path.ends_with(".rs")).map(|it| it.text.as_str()).collect();
    let is_gone = |title: &&&str| {
        let name = title.rsplit("::").next().unwrap_or_default();
        !sources.contains(&format!("#[test]\nfn {name}() {{"))
    };
    let all = xtask::alternate::TESTS.into_iter().flatten();
    none(
        "a test that alternates is not there",
        &all.filter(is_gone).map(|it| (*it).to_owned()).collect::<Vec<_>>(),
    );
}

#[test]
fn what_is_not_built_as_a_test_has_none() {
    let root = root();
    let mut offences = Vec::new();
    for package in packages() {
        let targets = package["targets"].as_array().into_iter().flatten();
        let folders = |tested: bool| -> BTreeSet<&Path> {
            let such = targets.clone().filter(|target| target["test"] == tested);
            such.filter_map(|target| Path::new(target["src_path"].as_str()?).parent()).collect()
        };
        for folder in folders(false).difference(&folders(true)) {
            let within =
                |file: &File| file.is_source() && root.join(&file.path).starts_with(folder);
            let tested = |file: &File| file.text.lines().any(|line| line.trim() == "#[test]");
            let found = files().into_iter().filter(|file| within(file) && tested(file));
            offences.extend(found.map(|file| file.path));
        }
    }
    none("what says `test = false` has no tests", &offences);
}

/// Checks that `doctest = false` is set exactly for libraries without examples in their documentation.
#[test]
fn what_is_not_read_for_examples_has_none() {
    let root = root();
    let mut offences = Vec::new();
    for package in packages() {
        let is_library = |target: &&Value| {
            let kinds = target["kind"].as_array().into_iter().flatten();
            kinds.into_iter().any(|kind| kind == "lib" || kind == "proc-macro")
        };
        let targets = package["targets"].as_array().into_iter().flatten();
        for library in targets.filter(is_library) {
            let folder = Path::new(library["src_path"].as_str().expect("a path")).parent();
            let within = |file: &File| {
                file.is_source() && folder.is_some_and(|it| root.join(&file.path).starts_with(it))
            };
            let has_some = files().iter().any(|file| within(file) && has_example(&file.text));
            if has_some != (library["doctest"] == true) {
                offences.push(format!("{}: {has_some}", library["src_path"]));
            }
        }
    }
    none("`doctest = false` says that a library has no example", &offences);
}

/// Returns true if the documentation in a source has a block of Rust: every other fence opens one.
fn has_example(text: &str) -> bool {
    let comments = text.lines().map(str::trim);
    let comments = comments.filter_map(|it| it.strip_prefix("///").or(it.strip_prefix("//!")));
    let mut fences = comments.filter_map(|comment| comment.trim().strip_prefix("```")).step_by(2);
    fences.any(|language| matches!(language, "" | "no_run" | "should_panic"))
}

/// C is called from tests and benchmarks only, so the rest needs no `unsafe`.
#[test]
fn no_source_is_unsafe() {
    let calls_c = |file: &File| file.path.starts_with("tests/") || file.path.starts_with("bench/");
    let mut offences = Vec::new();
    for file in files().iter().filter(|file| file.is_source() && !calls_c(file)) {
        match file.text.parse::<TokenStream>() {
            Ok(tokens) => {
                unsafe_lines(tokens, &mut |line| offences.push(format!("{}:{line}", file.path)))
            }
            Err(error) => offences.push(format!("{}: {error}", file.path)),
        }
    }
    none("`unsafe` only where C is called, in tests and benchmarks", &offences);
}

/// Reports the line of each `unsafe` that opens a block or an item. Texts and comments are not tokens of that kind,
/// and `Token![unsafe]`, as a macro that refuses it writes, opens nothing.
fn unsafe_lines(tokens: TokenStream, report: &mut dyn FnMut(usize)) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Group(group) => unsafe_lines(group.stream(), report),
            TokenTree::Ident(word) if word == "unsafe" && tokens.peek().is_some_and(opens) => {
                report(word.span().start().line);
            }
            _ => {}
        }
    }
}

fn opens(token: &TokenTree) -> bool {
    match token {
        TokenTree::Group(group) => group.delimiter() == proc_macro2::Delimiter::Brace,
        TokenTree::Ident(word) => {
            ["fn", "impl", "trait", "extern"].iter().any(|keyword| word == keyword)
        }
        _ => false,
    }
}

#[test]
fn the_search_for_unsafe_finds_it() {
    let found = |text: &str| {
        let mut lines = Vec::new();
        unsafe_lines(text.parse().expect("Rust"), &mut |line| lines.push(line));
        lines.len()
    };
    assert_eq!(found("fn f() { let x = 1; unsafe { g() } }"), 1);
    assert_eq!(found("unsafe fn f() {} unsafe impl A for B {} unsafe extern \"C\" {}"), 3);
    assert_eq!(
        found("//! `unsafe { }`\nfn f() { input.peek(Token![unsafe]); say(\"unsafe { }\") }"),
        0
    );
}
