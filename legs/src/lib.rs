//! Legs that execute a model besides rustc. They are the interpreter of its IR, and its C by each compiler on the host
//! and on the emulated Cortex-A9.
//!
//! Invariants: inputs and outputs are words (64 bits each, in the order of `Plain`), so that nothing here knows the
//! meaning of a model; C runs in a separate process, so nothing needs `unsafe`.
//!
//! What it must not know: any model, any test.

pub mod arguments;
pub mod board;
pub mod entries;
pub mod firmware;
pub mod harness;
pub mod interpreter;
pub mod kernels;
pub mod lockstep;
pub mod longest;
pub mod machines;
mod objects;
pub mod outcome;
pub mod panics;
pub mod port;
pub mod process;
pub mod random;
pub mod reached;
pub mod running;
pub mod serial;
pub mod toolchain;
pub mod trees;
mod units;
pub mod watch;
pub mod zig;

pub use bessemer_store as store;
pub use bessemer_words::{digest, value, words};

use std::path::PathBuf;

/// Returns the root of the workspace.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

use bessemer_backend::c::CFile;
use bessemer_codegen::compile::{self, Compiled};
use bessemer_codegen::generate;
use bessemer_frontend::diagnostic;
use bessemer_frontend::source::Sources;
use bessemer_ir::{FunctionId, Role};

/// Returns true if this build panics on overflow, where the C faults. A build that wraps would not be comparable.
pub fn overflow_is_checked() -> bool {
    let largest = std::hint::black_box(u8::MAX);
    panics::caught(|| largest + std::hint::black_box(1)).is_err()
}

/// Compiles a package of this workspace.
///
/// # Panics
///
/// If it does not compile: no test can run then.
pub fn compiled(package: &str) -> Compiled {
    compiled_with(package, &compile::Options::default())
}

/// Compiles a package with options.
///
/// # Panics
/// If it does not compile.
pub fn compiled_with(package: &str, options: &compile::Options) -> Compiled {
    assert!(overflow_is_checked(), "set `overflow-checks = true` in the profile");
    let sources = Sources::new(root());
    let tree = trees::tree(&generate::Job::new(root(), package), &trees::folders());
    let package = tree.unwrap_or_else(|error| panic!("{error}")).package;
    let compiled = compile::compile(&package, &sources, options)
        .unwrap_or_else(|errors| panic!("{}", diagnostic::render(&errors, &sources, false)));
    for name in &compiled.names {
        bessemer::name::register(name.clone().leak());
    }
    // To look at the C of a test's package: `BESSEMER_SHOW=folder cargo test …`.
    if let Some(folder) = std::env::var_os("BESSEMER_SHOW") {
        for file in &compiled.files {
            let path = std::path::Path::new(&folder).join(&file.name);
            let _ = path.parent().map(std::fs::create_dir_all);
            std::fs::write(path, &file.text).expect("a folder to show the C in");
        }
    }
    compiled
}

/// Returns the names and texts of the files, for the key of a stored check.
pub fn texts(files: &[CFile]) -> Vec<(&str, &str)> {
    files.iter().map(|file| (file.name.as_str(), file.text.as_str())).collect()
}

/// Returns the entry point `owner::name` of a module.
pub fn entry(compiled: &Compiled, owner: &str, name: &str) -> Option<FunctionId> {
    let module = &compiled.module;
    let index = module.functions.iter().position(|function| {
        let of = match function.owner {
            Some(bessemer_ir::Owner::Struct(id)) => module.structs[id.index()].name.as_str(),
            _ => "",
        };
        matches!(function.role, Role::Entry { .. }) && function.name == name && of == owner
    })?;
    Some(FunctionId(index as u32))
}
