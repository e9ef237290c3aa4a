#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A gain.
pub struct Gain {
    value: f64,
}

impl Gain {
    #[function]
    fn respond(&self, x: f64) -> f64 {
        self.value * x
    }
}

fn main() {}
