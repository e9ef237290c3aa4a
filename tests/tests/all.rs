//! One program of all tests across the crates: what several of them compile, such as the corpus, is compiled once,
//! and the test runner keeps every processor busy to the end.
//!
//! `cargo test -p bessemer-tests corpus::` runs one module.

mod asked;
mod corpus;
mod coverage;
mod deep;
mod delivery;
mod diagnosed;
mod edges;
mod emitted;
mod ends;
mod eva;
mod fast_mode;
mod flight;
mod guards;
mod kernel_options;
mod kinds;
mod language;
mod large;
mod layouts;
mod linear;
mod mathematics;
mod onboard;
mod random;
mod readme;
mod refused;
mod self_test;
mod stability;
mod target_math;
mod text;
mod types;
mod walks;
mod work;

/// A file that is dropped in beside this one is run.
#[test]
fn every_module_is_named() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests");
    for entry in std::fs::read_dir(folder).expect("the folder of the tests").flatten() {
        let path = entry.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let named = include_str!("all.rs").contains(&format!("\nmod {name};\n"));
        assert!(
            named || ["all", "snapshots"].contains(&name.as_str()),
            "no `mod {name};` in all.rs"
        );
    }
}
