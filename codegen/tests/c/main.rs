//! The C back end: what it emits for the modules in `tests/c/*.ir`, and that every compiler at hand
//! takes it without a warning. Dropping in a file adds a test.

mod compilers;
mod run;

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use bessemer_codegen::c::{CFile, Options, emit, report};
use bessemer_codegen::validate::validate;
use bessemer_ir::Module;

fn load(path: &Path) -> Module {
    let text = std::fs::read_to_string(path).expect("the file is there");
    let module = bessemer_ir::text::parse(&text)
        .unwrap_or_else(|error| panic!("{}: {error:?}", path.display()));
    validate(&module).unwrap_or_else(|errors| panic!("{}: {errors:#?}", path.display()));
    module
}

/// The module as the back end takes it.
fn explicit(path: &Path) -> Module {
    let passed = bessemer_codegen::passes::explicit(load(path));
    passed.unwrap_or_else(|errors| panic!("{}: {errors:#?}", path.display())).0
}

fn modules() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/c");
    let entries = std::fs::read_dir(folder).expect("the folder is there");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("readable").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "ir"));
    paths.sort();
    paths
}

/// The files one after another, and the report.
fn show(module: &Module, files: &[CFile]) -> String {
    let mut text = String::new();
    for file in files {
        let _ = writeln!(text, "======== {}\n{}", file.name, file.text);
    }
    for entry in report(module, &Options::default(), files) {
        let _ = writeln!(text, "{entry:?}");
    }
    text
}

#[test]
fn emitted_c() {
    for path in modules() {
        let module = explicit(&path);
        let files = emit(&module, &Options::default());
        let name = path.file_stem().expect("a file").to_string_lossy().into_owned();
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path("");
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.bind(|| insta::assert_snapshot!(name, show(&module, &files)));
    }
}

#[test]
fn compiles_without_a_warning() {
    for path in modules() {
        let files = emit(&explicit(&path), &Options::default());
        compilers::check(&path.file_stem().expect("a file").to_string_lossy(), &files);
    }
}

#[test]
fn the_map_points_at_code() {
    for path in modules() {
        for file in emit(&explicit(&path), &Options::default()) {
            let lines: Vec<&str> = file.text.lines().collect();
            for entry in &file.map {
                let line = lines[entry.c_line as usize - 1].trim();
                assert!(!line.is_empty() && !line.starts_with("/*"), "{}: {entry:?}: {line}", file.name);
            }
            assert!(file.map.is_sorted_by_key(|entry| entry.c_line), "{}", file.name);
        }
    }
}

#[test]
fn computes_what_the_interpreter_computes() {
    for path in modules() {
        let (module, explicit) = (load(&path), explicit(&path));
        let files = emit(&explicit, &Options::default());
        let name = path.file_stem().expect("a file").to_string_lossy().into_owned();
        run::compare(&name, &module, &explicit, &files);
    }
}
