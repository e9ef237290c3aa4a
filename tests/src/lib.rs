//! The legs of every comparison: the model as rustc compiles it, the interpreter of its IR, and its C
//! as each compiler makes it, on the host and on the emulated Cortex-A9.
//!
//! C runs as a process of its own, so no test needs `unsafe`: words go in and come out through pipes,
//! and the target is one more program.

pub mod batch;
pub mod edge_values;
pub mod harness;
pub mod interpreter;
pub mod pilot;
pub mod process;
pub mod toolchain;
pub mod workspace;

use std::path::PathBuf;

use bessemer::Plain;

/// The root of the workspace.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The words of a value.
pub fn words(value: &impl Plain) -> Vec<u64> {
    let mut words = Vec::new();
    value.store(&mut |word| words.push(word));
    words
}

/// The value of words.
pub fn value<T: Plain>(words: &[u64]) -> T {
    let mut words = words.iter().copied();
    T::load(&mut || words.next().unwrap_or_default())
}

use std::sync::OnceLock;

use bessemer_codegen::compile::{self, Compiled};
use bessemer_codegen::source::Sources;
use bessemer_codegen::{diagnostic, generate};

/// Whether this build panics on overflow, as the C faults; a build that wraps is another program.
pub fn overflow_is_checked() -> bool {
    let largest = std::hint::black_box(u8::MAX);
    std::panic::catch_unwind(|| largest + std::hint::black_box(1)).is_err()
}

/// The flight models, compiled once for a test program.
///
/// # Panics
/// If they do not compile, or if this build does not check overflow: nothing can be compared then.
pub fn flight_models() -> &'static Compiled {
    static COMPILED: OnceLock<Compiled> = OnceLock::new();
    COMPILED.get_or_init(|| compiled("models"))
}

/// The hard programs, compiled once for a test program.
///
/// # Panics
/// If they do not compile: no test can run then.
pub fn corpus() -> &'static Compiled {
    static COMPILED: OnceLock<Compiled> = OnceLock::new();
    COMPILED.get_or_init(|| compiled("corpus"))
}

/// A package of this workspace, compiled.
///
/// # Panics
/// If it does not compile: no test can run then.
pub fn compiled(package: &str) -> Compiled {
    assert!(overflow_is_checked(), "set `overflow-checks = true` in the profile");
    let sources = Sources::new(root());
    let package = generate::tree(&root(), package).unwrap_or_else(|error| panic!("{error}"));
    compile::compile(&package, &sources, &compile::Options::default())
        .unwrap_or_else(|errors| panic!("{}", diagnostic::render(&errors, &sources, false)))
}
