//! Stored trees of programs of the corpus give the IR of their golden files: the front half alone, without cargo or rustc.
//!
//! `UPDATE_DOCS=1 cargo test -p bessemer-frontend --test programs` writes the IR of these programs. The IR of all programs,
//! and the trees, are written by the test of the same name in `legs/`.

mod door;

use std::fs;
use std::path::{Path, PathBuf};

use door::{Items, LIBRARY, deep, differs, file, files};

/// Least number of stored trees.
const PROGRAMS: usize = 60;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn stored_trees_give_the_golden_ir() {
    let (trees, golden) = (door::trees(&root()), door::golden(&root()));
    let read = |path: &Path| fs::read_to_string(path).expect("a stored tree");
    let library = read(&file(&trees, LIBRARY, "json"));
    let mut programs = files(&trees, "json");
    programs.retain(|module, _| !module.ends_with(LIBRARY));
    assert!(programs.len() >= PROGRAMS, "{} stored trees", programs.len());
    let differences = deep(|| {
        let difference = |(module, path): (&String, &PathBuf)| {
            let items = Items::read("corpus", &[&library, &read(path)]);
            let items = items.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            match items.ir(module) {
                Ok(text) => differs(&file(&golden, module, "ir"), &text),
                Err(errors) => Some(format!("{module} is refused: {errors:?}")),
            }
        };
        programs.iter().filter_map(difference).collect::<Vec<_>>()
    });
    let shown = differences.join("\n  ");
    let renewal = "UPDATE_DOCS=1 cargo test -p bessemer-frontend --test programs";
    assert!(differences.is_empty(), "read these differences, then run {renewal}:\n  {shown}\n");
}
