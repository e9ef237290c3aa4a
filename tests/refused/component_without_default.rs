#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Its initial state is not known.
#[component]
pub struct Height {
    /// The integral of the error, m·s.
    pub integral: f64,
}

fn main() {}
