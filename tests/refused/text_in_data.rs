#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Named.
#[data]
pub struct Channel {
    /// Its name.
    pub name: &'static str,
}

fn main() {}
