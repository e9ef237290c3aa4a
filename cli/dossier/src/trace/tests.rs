//! Tests of the trace, on small files and on the committed C of the models.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::*;
use crate::scan::Kind;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn models() -> Folder {
    Folder::read(&root().join("generated")).expect("the committed C")
}

fn found(line: &str) -> String {
    let line = Line::of(line).expect("a line");
    described(&models(), &Workspace(&root()), &line).unwrap_or_else(|error| panic!("{error}"))
}

/// Each executed statement of a file with a map has its Rust.
#[test]
fn every_statement_has_a_counterpart() {
    let folder = models();
    let (mut statements, mut none) = (0, Vec::new());
    for file in folder.files.iter().filter(|file| !file.rows.is_empty()) {
        for it in file.functions.iter().flat_map(|function| &function.statements) {
            statements += 1;
            if file.counterpart(it.line).is_none() {
                none.push(format!("{}:{}", file.name, it.line));
            }
        }
    }
    assert!(statements > 2000, "{statements} statements");
    assert!(none.is_empty(), "without Rust: {}", none.join(" "));
    println!("{statements} statements, each with its Rust");
}

/// A statement of the author's code has a row of its own, not only one before it.
#[test]
fn every_statement_outside_of_kernels_has_its_own_row() {
    let folder = models();
    let mut none = Vec::new();
    let mapped = |file: &&File| file.rows.iter().any(|row| !row.function.contains("kernels"));
    for file in folder.files.iter().filter(mapped) {
        for it in file.functions.iter().flat_map(|function| &function.statements) {
            let own = file.rows.iter().any(|row| (it.line..=it.last_line).contains(&row.c_line));
            if !own && it.kind != Kind::Declaration {
                none.push(format!("{}:{}", file.name, it.line));
            }
        }
    }
    assert!(none.is_empty(), "without a row: {}", none.join(" "));
}

#[test]
fn a_line_of_c_leads_to_its_rust_and_back() {
    let folder = models();
    let file = folder.file("height.c").expect("it");
    let at = file.text.lines().position(|line| line.contains("if (target->take_off)"));
    let at = at.expect("the line") + 1;
    let text = found(&format!("generated/height.c:{at}"));
    assert!(text.contains("in height_step"), "{text}");
    assert!(text.contains("models/src/height.rs:"), "{text}");
    let rust = text.lines().find(|line| line.starts_with("models/")).expect("the Rust");
    let back = found(rust.split_whitespace().next().expect("a place"));
    assert!(back.contains(&format!("height.c:{at}  in height_step")), "{back}");
}

#[test]
fn a_line_of_rust_without_c_leads_to_the_nearest_one() {
    let folder = models();
    let row = folder.file("height.c").expect("it").rows.first().expect("a row").clone();
    let text = found(&format!("height.rs:{}", row.rust_line - 1));
    assert!(text.contains("no C by itself"), "{text}");
}

#[test]
fn lines_are_read_as_compilers_print_them() {
    let line = |text: &str| Line::of(text).map(|it| (it.file, it.line)).ok();
    assert_eq!(line("a/b.c:7"), Some(("a/b.c".to_owned(), 7)));
    assert_eq!(line("a/b.c:7:12"), Some(("a/b.c".to_owned(), 7)));
    assert_eq!(line("C:\\a\\b.c:7"), Some(("C:\\a\\b.c".to_owned(), 7)));
    for wrong in ["a.c", "a.c:", "a.c:x", "a.c:0", "a.c:-1", ":", ""] {
        assert!(line(wrong).is_none(), "{wrong}");
    }
}

#[test]
fn mistakes_are_named() {
    let of = |line: &str| {
        let line = Line::of(line).expect("a line");
        let error = described(&models(), &Workspace(&root()), &line).expect_err("it is wrong");
        format!("{error}; {}", error.remedy().unwrap_or_default())
    };
    assert_eq!(
        of("nothing.c:1"),
        "the C has no file `nothing.c`; name a file of the folder that `cargo bessemer gen` writes"
    );
    assert_eq!(of("height.cc:1"), "the C has no file `height.cc`; choose from height.c, height.h");
    assert!(of("height.c:9999").starts_with("`height.c` has "));
    assert!(of("heigh.rs:1").starts_with("no C comes from `heigh.rs`; "));
    assert!(matches!(Folder::read(Path::new("/nowhere")), Err(Error::NoFolder { .. })));
}

#[test]
fn a_map_that_is_none_or_of_other_c_is_refused() {
    let folder = |map: &str| {
        let texts = BTreeMap::from([
            ("a.c".to_owned(), "int a;\n".to_owned()),
            ("a.c.map".to_owned(), map.to_owned()),
        ]);
        Folder::of(&texts, Path::new("x"))
    };
    assert!(folder("# C line\n1\tm/a.rs:2\tm::a\n").is_ok());
    assert!(matches!(folder("1\tm/a.rs:2\tm::a\nx\n"), Err(Error::Map { line: 2, .. })));
    assert!(matches!(folder("7\tm/a.rs:2\tm::a\n"), Err(Error::Edited { line: 7, last: 1, .. })));
}

/// Names that only the C has are explained.
#[test]
fn temporaries_are_explained() {
    let folder = models();
    let file = folder.file("mixer.c").expect("it");
    let number = |text: &str| {
        let found = file.text.lines().position(|line| line.contains(text));
        found.expect("the line") + 1
    };
    let text = found(&format!("mixer.c:{}", number("const double kept_share")));
    assert!(text.contains("`kept_base`: a constant value"), "{text}");
    let text = found(&format!("mixer.c:{}", number("squares[i] = command->speeds[i]")));
    assert!(text.contains("`i`: counts the passes"), "{text}");
}
