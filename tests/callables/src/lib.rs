//! Functions of test programs that can be called with words. `tests/corpus` and `tests/plain` list their functions in
//! this form, and the tests call them.
//!
//! It must not know what a program computes.

#![no_std]

/// A function, an entry point or a method of plain data, callable by words.
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
