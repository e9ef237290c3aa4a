#![no_std]
extern crate std;

use bessemer::prelude::*;

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
