#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A slice in a state, which outlives the call.
#[component]
pub struct Held<'a> {
    samples: &'a [f64],
}

/// A slice whose length is not known.
#[data]
pub struct Bare<'a> {
    samples: &'a f64,
    rest: [f64],
}

fn main() {}
