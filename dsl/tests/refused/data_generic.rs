#![no_std]
extern crate std;

use bessemer::prelude::*;

/// For any float.
#[data]
pub struct Gains<T> {
    /// Proportional.
    pub p: T,
}

fn main() {}
