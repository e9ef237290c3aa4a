//! The legs of every comparison: the model as rustc compiles it, the interpreter of its IR, and its C
//! as each compiler makes it, on the host and on the emulated Cortex-A9.
//!
//! C runs as a process of its own, so no test needs `unsafe`: words go in and come out through pipes,
//! and the target is one more program.

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

/// The flight models, compiled once for a test program.
///
/// # Panics
/// If they do not compile: no test can run then.
pub fn flight_models() -> &'static Compiled {
    static COMPILED: OnceLock<Compiled> = OnceLock::new();
    COMPILED.get_or_init(|| {
        let sources = Sources::new(root());
        let package = generate::tree(&root(), "models").unwrap_or_else(|error| panic!("{error}"));
        compile::compile(&package, &sources, &compile::Options::default())
            .unwrap_or_else(|errors| panic!("{}", diagnostic::render(&errors, &sources, false)))
    })
}
