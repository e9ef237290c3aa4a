#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Borrows its limits: its state outlives every call.
#[component]
pub struct Clipped<'a> {
    /// The limits.
    pub limits: &'a [f64; 2],
    /// Two values of others.
    pub pair: [&'a f64; 2],
}

fn main() {}
