//! Holds the IR of each program of the corpus to a golden file. The stored trees, which the front half's own tests read,
//! are held to the corpus, and so are the bodies of derivatives.
//!
//! `UPDATE_DOCS=1 cargo test -p bessemer-legs --test programs` writes both. A program gets a stored tree when an empty file
//! for it is there.

#[path = "../../codegen/frontend/tests/programs/door.rs"]
mod door;

use std::collections::BTreeSet;
use std::sync::LazyLock;

use bessemer_codegen::derivatives;
use bessemer_codegen::generate::Job;
use bessemer_frontend::source::Sources;
use bessemer_ir::tree::Package;
use bessemer_legs::{root, trees};
use door::{Items, LIBRARY, deep, differs, file, files};

const RENEWAL: &str = "UPDATE_DOCS=1 cargo test -p bessemer-legs --test programs";

/// The tree of the corpus.
static PACKAGE: LazyLock<Package> = LazyLock::new(|| {
    let tree = trees::tree(&Job::new(root(), "corpus"), &trees::folders());
    tree.unwrap_or_else(|error| panic!("{error}")).package
});

/// The items of the corpus, their files named from the root on.
static CORPUS: LazyLock<Items> =
    LazyLock::new(|| deep(|| Items::of(PACKAGE.clone(), "tests/corpus/src/")));

/// Fails with the differences, each of a file.
#[track_caller]
fn none(differences: &[String]) {
    let shown = differences.join("\n  ");
    assert!(differences.is_empty(), "read these differences, then run {RENEWAL}:\n  {shown}\n");
}

#[test]
fn the_ir_of_each_program_is_golden() {
    let folder = door::golden(&root());
    let modules = CORPUS.modules();
    let mut differences = deep(|| {
        let ir = |module: &&str| match CORPUS.ir(module) {
            Ok(text) => differs(&file(&folder, module, "ir"), &text),
            Err(errors) => Some(format!("{module} is refused by itself: {errors:?}")),
        };
        modules.iter().filter_map(ir).collect::<Vec<_>>()
    });
    for (module, path) in files(&folder, "ir") {
        if !modules.contains(module.as_str()) {
            differences.push(format!("{}: there is no such program", path.display()));
        }
    }
    none(&differences);
}

#[test]
fn the_stored_trees_are_those_of_the_programs() {
    let folder = door::trees(&root());
    let stored = files(&folder, "json");
    let (mut library, mut differences) = (BTreeSet::new(), Vec::new());
    for (module, path) in stored.iter().filter(|(module, _)| !module.ends_with(LIBRARY)) {
        if !CORPUS.modules().contains(module.as_str()) {
            differences.push(format!("{}: there is no such program", path.display()));
            continue;
        }
        let [others, programs] = deep(|| CORPUS.lines(module));
        library.extend(others);
        differences.extend(differs(path, &text(&programs)));
    }
    differences.extend(differs(&file(&folder, LIBRARY, "json"), &text(&library)));
    none(&differences);
}

/// Bodies of derivatives are those that the generator writes. After a renewal their IR is stale: renew twice.
#[test]
fn the_derivatives_are_those_of_the_functions() {
    let edits = derivatives::edits(&PACKAGE, &Sources::new(root()));
    let edits = edits.unwrap_or_else(|errors| panic!("{errors:?}"));
    let differences = edits.iter().filter_map(|it| differs(&root().join(&it.file), &it.after));
    none(&differences.collect::<Vec<_>>());
}

/// Writes a line for each item.
fn text(items: &BTreeSet<(usize, &str)>) -> String {
    items.iter().map(|(_, line)| format!("{line}\n")).collect()
}
