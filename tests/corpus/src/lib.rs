//! Small programs, one for each construct and each edge of the language, and ported algorithms.
//!
//! Every file below `programs/` is a program, and its folder is its topic. Dropping in a file adds a test:
//! `tests/tests/corpus/mod.rs` runs each `#[function]` and each `#[entry]` in it natively, in the interpreter
//! and as C. The programs of a topic's `corner_cases/` are hard on a compiler and no examples to follow: the book leaves
//! them out. In `programs/kinds/` a file is a kind of data, and brings the functions that show what each kind can do
//! (`six.in`, `floats.in`).

#![no_std]
#![allow(
    missing_docs,
    non_snake_case,
    mixed_script_confusables,
    non_upper_case_globals,
    clippy::all,
    unused_parens,
    unused_assignments,
    unused_variables,
    dead_code
)]

pub use callables::Entry;

/// The programs, found by the build script.
pub mod programs {
    include!(concat!(env!("OUT_DIR"), "/programs.rs"));
}
