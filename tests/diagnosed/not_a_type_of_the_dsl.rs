//! A case.
#![no_std]
use bessemer::prelude::*;

/// Plain Rust, unknown to the DSL.
#[derive(Clone, Copy)]
pub struct Unknown {
    /// A field.
    pub x: f64,
}

/// Holds one in a variable.
#[function]
pub fn caller(x: f64) -> f64 {
    let unknown = Unknown { x };
    unknown.x
}
