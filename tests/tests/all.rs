//! One program of all tests across the crates. Shared inputs such as the corpus are compiled once, and the test runner
//! keeps every processor busy. The tests of a module run in one process: those that need the same models are together.
//!
//! `cargo test -p bessemer-tests corpus::` runs one module.

mod as_nalgebra;
mod asked;
mod command;
mod corpus;
mod deep;
mod delivery;
mod diagnosed;
mod edges;
mod ends;
mod examples;
mod fast_mode;
mod firmware;
mod flight;
mod interface;
mod kept;
mod kernel_options;
mod large;
mod layouts;
mod linear;
mod linked;
mod mathematics;
mod newcomers;
mod packs;
mod parameters;
mod plain;
mod random;
mod readme;
mod refused;
mod self_test;
mod shown;
mod stability;
mod target_math;
mod types;
mod walks;
mod work;

use std::path::Path;

/// A file that is dropped in anywhere below is run.
#[test]
fn every_module_is_named() {
    every_file_is_named(Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests")), "all.rs");
}

/// The files and folders of `folder`, in the file there that names them.
fn every_file_is_named(folder: &Path, naming: &str) {
    let text = std::fs::read_to_string(folder.join(naming)).expect("what names the modules");
    for entry in std::fs::read_dir(folder).expect("a folder of tests").flatten() {
        let path = entry.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let is_module = path.is_dir() || path.extension().is_some_and(|it| it == "rs");
        if !is_module || path.file_name() == Some(naming.as_ref()) || name == "snapshots" {
            continue;
        }
        let named = text.contains(&format!("\nmod {name};\n"));
        assert!(named, "no `mod {name};` in {}", folder.join(naming).display());
        if path.is_dir() {
            every_file_is_named(&path, "mod.rs");
        }
    }
}
