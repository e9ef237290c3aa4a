//! Errors of computers under test. Each says what to do.

use std::path::PathBuf;

use bessemer_ir::Fault;
use bessemer_legs::{board, process};

/// Reason why a computer cannot run, or stopped.
#[derive(Debug, thiserror::Error)]
pub enum Error {
    /// The package of models is not found or does not compile.
    #[error("{0}")]
    Project(#[from] bessemer_project::Error),
    /// No entry point has the name.
    #[error("there is no entry point `{name}`; there are: {}", known.join(", "))]
    NoEntry {
        /// The name.
        name: String,
        /// Names of all entry points.
        known: Vec<String>,
    },
    /// An entry point borrows a slice, whose length only its caller knows.
    #[error("`{0}` borrows a slice, which has no fixed number of words; borrow an array")]
    Slice(String),
    /// No compiler of C is there.
    #[error("neither gcc nor clang can be run; install one: apt install gcc")]
    NoCompiler,
    /// The compiler or the system failed.
    #[error("{0}")]
    Process(#[from] process::Error),
    /// A call has another number of words than the entry point takes.
    #[error(
        "`{name}` takes {wanted} words beside its component, and the call has {found}; pass a tuple of its arguments in their order"
    )]
    Words {
        /// The entry point.
        name: String,
        /// Number of words of the call.
        found: usize,
        /// Number of words that it takes.
        wanted: usize,
    },
    /// A result has another number of words than the type that is read from it.
    #[error(
        "the result has {found} words, and the argument of `command` {wanted}; let `command` take the type that the entry point returns"
    )]
    Result {
        /// Number of words of the result.
        found: usize,
        /// Number of words of the type.
        wanted: usize,
    },
    /// The controller met a fault, where its Rust would panic.
    #[error("`{name}` met the fault {fault:?}; its Rust panics with the same arguments")]
    Fault {
        /// The entry point.
        name: String,
        /// Kind of the fault.
        fault: Fault,
    },
    /// The interpreter stopped for another reason than a fault.
    #[error("`{name}` cannot be interpreted: {why}; please report this")]
    Stop {
        /// The entry point.
        name: String,
        /// Its message.
        why: String,
    },
    /// A serial port cannot be opened.
    #[error("`{path}`: {source}; is the board connected, and may you use the port?")]
    Port {
        /// Path of the port.
        path: PathBuf,
        /// Error of the system.
        source: std::io::Error,
    },
    /// A board failed.
    #[error(
        "{0}; build what `cargo bessemer verify --board FOLDER` writes, load it, and check the speed of the line"
    )]
    Board(#[from] board::Error),
    /// A co-simulation unit cannot be used.
    #[error("`{path}`: {why}")]
    Unit {
        /// Path of the unit.
        path: PathBuf,
        /// The defect, and the remedy.
        why: String,
    },
    /// A co-simulation unit reported an error, or ended.
    #[error("the unit failed in period {period}: {said}")]
    UnitFailed {
        /// Number of the period, from 0.
        period: u64,
        /// Its message.
        said: String,
    },
}
