#![no_std]
extern crate std;

use bessemer::prelude::*;

/// With payload.
#[data]
#[derive(Clone, Copy)]
pub enum Mode {
    /// Nothing.
    Idle,
    /// A height.
    Hold(f64),
    /// A place.
    Fly { x: f64, y: f64 },
}

/// With a value.
#[data]
pub enum Port {
    /// Its number.
    Serial = 7,
}

/// Without variants.
#[data]
pub enum Nothing {}

fn main() {}
