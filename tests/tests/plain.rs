//! Programs in plain Rust written without knowledge of the DSL (`tests/plain/`). With attributes and imports alone they
//! become C, and native Rust, interpreter and C have the same bits and faults.
//!
//! Those that do not go yet are in a table, each with its reason: one that goes by now is reported.

use std::fs;
use std::path::PathBuf;
use std::sync::OnceLock;

use bessemer_codegen::compile::{Compiled, Options};
use bessemer_frontend::diagnostic;
use bessemer_frontend::source::Sources;
use bessemer_interpret::Interpreter;
use bessemer_tests::compiled_with;
use bessemer_tests::toolchain;
use bessemer_tests::workspace::Workspace;
use callables::Entry;

use super::corpus::{interpreted, lived, run_c, run_c_with};
use super::newcomers::step;

#[path = "../plain/marked.rs"]
mod marked;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("plain")
}

/// Returns their callable functions.
fn entries() -> impl Iterator<Item = &'static Entry> {
    plain::programs::ENTRIES.iter().copied().flatten()
}

/// The programs, compiled as a user would have them, and with the checks that were proved.
fn compiled() -> (&'static Compiled, &'static Options) {
    static COMPILED: OnceLock<(Compiled, Options)> = OnceLock::new();
    let (compiled, options) = COMPILED.get_or_init(|| {
        let options = Options { keep_checks: true, ..Options::default() };
        (compiled_with("plain", &options), options)
    });
    (compiled, options)
}

#[test]
fn every_leg_agrees() {
    let (kept, options) = compiled();
    let cases = lived(kept, entries());
    for module in [&kept.module, &kept.explicit] {
        let mut interpreter = Interpreter::new(module);
        cases.iter().for_each(|case| interpreted(kept, module, &mut interpreter, case));
    }
    let host = toolchain::host();
    if let Some(gcc) = host.iter().find(|it| it.compiler == "gcc" && it.level == 0) {
        run_c_with(kept, &cases, gcc, &["-w"], options);
    }
    let optimised = compiled_with("plain", &Options::default());
    if let Some(toolchain) = host.iter().find(|it| it.level == 3) {
        run_c(&optimised, &cases, toolchain, &[]);
    }
}

/// Checks that the listed programs do not become C.
#[test]
fn what_goes_is_not_listed() {
    let folder = folder();
    let (_, mut listed) = marked::programs(&folder).expect("the programs");
    let workspace = Workspace::with_source("").expect("a workspace");
    let manifest = workspace.folder().join("Cargo.toml");
    let text = fs::read_to_string(&manifest).expect("the manifest");
    let more =
        ["libm", "nalgebra", "num-traits"].map(|it| format!("{it} = {{ workspace = true }}\n"));
    let with = format!("[dependencies]\n{}", more.concat());
    fs::write(&manifest, text.replace("[dependencies]\n", &with)).expect("the manifest");
    for name in &listed {
        let text = marked::marked(&folder, name).expect("a program and its marks");
        let path = workspace.folder().join("src").join(format!("{name}.rs"));
        fs::write(path, text).expect("a module");
    }
    while !listed.is_empty() {
        let (told, is_last) = step(&workspace, &listed);
        // Told with `--nocapture`.
        let sources = Sources::new(workspace.path(""));
        told.values().for_each(|told| println!("{}", diagnostic::render(told, &sources, false)));
        let before = listed.len();
        listed.retain(|name| !told.contains_key(name));
        assert!(!is_last && listed.len() < before, "these become C, and are listed: {listed:?}");
    }
}
