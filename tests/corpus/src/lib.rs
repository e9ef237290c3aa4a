//! Small programs, one for each construct and each edge of the language, and ported algorithms.
//!
//! Every file below `programs/` is a program; its folder says what of. Dropping in a file adds a test:
//! `tests/tests/corpus/mod.rs` runs each `#[function]` and each `#[entry]` in it natively, in the interpreter
//! and as C. `programs/trouble/` is hard on a compiler and no example to follow; in `programs/kinds/` a file is a kind of
//! data, and brings the functions that show what each kind can do (`six.in`, `floats.in`).

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

/// A function or an entry point, callable by words.
pub struct Entry {
    /// The path of its module.
    pub module: &'static str,
    /// The component's name; empty for a function.
    pub component: &'static str,
    /// The name of the plain data that it is a method of; empty for a function.
    pub data: &'static str,
    /// Its own.
    pub name: &'static str,
    /// Gives the words of the state and the arguments that are made of words: what is none of a type becomes one.
    pub made: fn(&mut dyn FnMut() -> u64, &mut dyn FnMut(u64)),
    /// Takes the words of the state and the arguments, gives those of the result, the state and what
    /// the arguments were changed to.
    pub run: fn(&mut dyn FnMut() -> u64, &mut dyn FnMut(u64)),
    /// Gives the words of the component's initial state, or of a first value of the data, if there is one.
    pub initial: fn(&mut dyn FnMut(u64)),
}

/// The programs, found by the build script.
pub mod programs {
    include!(concat!(env!("OUT_DIR"), "/programs.rs"));
}
