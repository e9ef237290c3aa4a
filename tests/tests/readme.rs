//! The README shows the project's own Rust and C, as they are.

use bessemer_tests::root;

/// The code blocks of one language.
fn blocks<'a>(text: &'a str, language: &str) -> Vec<&'a str> {
    let fence = format!("```{language}\n");
    text.split(&fence).skip(1).filter_map(|rest| rest.split("```").next()).collect()
}

fn read(name: &str) -> String {
    std::fs::read_to_string(root().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

#[test]
fn the_rust_and_the_c_side_by_side_are_the_committed_ones() {
    let readme = read("README.md");
    let rust = blocks(&readme, "rust")[0];
    assert!(read("models/src/height.rs").contains(rust.trim()), "not in height.rs:\n{rust}");
    let (header, source) = (read("generated/height.h"), read("generated/height.c"));
    for block in blocks(&readme, "c") {
        let known = header.contains(block.trim()) || source.contains(block.trim());
        assert!(known, "not in height.h or height.c:\n{block}");
    }
}

#[test]
fn the_files_that_it_links_are_there() {
    let readme = read("README.md");
    for rest in readme.split("](").skip(1) {
        // Whether the heading is there as well, `xtask/tests/pages` says.
        let target = rest.split([')', '#']).next().unwrap_or_default();
        if !target.starts_with("http") {
            assert!(root().join(target).exists(), "{target}");
        }
    }
}
