//! Small programs, one for each construct of control and structure.
//!
//! Each is a component with one entry point `run`, so that the native Rust, the interpreter and the C
//! can be driven alike: words in, words out, state kept.

#![no_std]
// The DSL has no such method yet.
#![allow(clippy::manual_is_multiple_of)]

pub mod choice;
pub mod each;
pub mod leaving;
pub mod parts;
pub mod passes;
pub mod rates;
