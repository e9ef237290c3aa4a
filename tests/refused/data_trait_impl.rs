#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A gain.
#[data]
#[derive(Clone, Copy)]
pub struct Gain {
    /// Its value.
    pub value: f64,
}

#[data]
impl Default for Gain {
    fn default() -> Gain {
        Gain { value: 1.0 }
    }
}

fn main() {}
