//! Programs in plain Rust with nalgebra, each written from its task alone by somebody who had never seen the DSL, with
//! attributes and imports, and nothing else, put beside them.
//!
//! `programs/` has them as they came, `marks/` what stands beside them, and README.md those that do not become C yet.

#![no_std]
#![allow(missing_docs, clippy::all, warnings)]

/// What of a program can be called with words.
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

/// The programs, with their marks.
pub mod programs {
    include!(concat!(env!("OUT_DIR"), "/programs.rs"));
}
