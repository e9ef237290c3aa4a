//! The legs of every comparison. They are the model as rustc compiles it, the interpreter of its IR, and its C by each
//! compiler on the host and on the emulated Cortex-A9.
//!
//! C runs in a separate process, with words through pipes, so no test needs `unsafe`, and the target is just another
//! program. The legs are in `bessemer-legs`, which the simulation uses, too.

pub mod alive;
pub mod batch;
pub mod edge_values;
pub mod golden;
pub mod linked;
pub mod pilot;
pub mod turn;
pub mod workspace;

pub use bessemer_legs::{
    arguments, compiled, compiled_with, entry, harness, interpreter, kernels, outcome,
    overflow_is_checked, panics, process, random, root, running, store, texts, toolchain, trees,
    value, watch, words,
};

use bessemer_backend::c::CFile;
use bessemer_codegen::compile::{Compiled, Options};
use std::path::PathBuf;
use std::sync::OnceLock;

/// The flight models, compiled once for a test program.
///
/// # Panics
/// If they do not compile, or if this build does not check overflow: nothing can be compared then.
pub fn flight_models() -> &'static Compiled {
    static COMPILED: OnceLock<Compiled> = OnceLock::new();
    COMPILED.get_or_init(|| compiled("models"))
}

/// The corpus, compiled once for a test program.
///
/// # Panics
///
/// If it does not compile: no test can run then.
pub fn corpus() -> &'static Compiled {
    static COMPILED: OnceLock<Compiled> = OnceLock::new();
    COMPILED.get_or_init(|| corpus_with(&Options::default()))
}

/// Compiles the corpus with options.
///
/// # Panics
///
/// If it does not compile.
pub fn corpus_with(options: &Options) -> Compiled {
    let mut compiled = compiled_with("corpus", options);
    compiled.files.extend(brought());
    compiled
}

/// The C that firmware would provide for the corpus' external functions.
fn brought() -> Vec<CFile> {
    let folder = root().join("tests/corpus/c");
    let entries = std::fs::read_dir(folder).expect("the folder of the C").flatten();
    let read = |path: PathBuf| CFile {
        name: path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        text: std::fs::read_to_string(&path).expect("a file of C"),
        map: Vec::new(),
    };
    entries.map(|entry| read(entry.path())).collect()
}
