#![no_std]
extern crate std;

use bessemer::prelude::*;

/// A gain.
#[data]
pub struct Gain {
    /// Its value.
    pub value: f64,
}

#[data]
impl Gain {
    /// Calls itself, both ways.
    pub fn power(&self, n: u32) -> f64 {
        if n == 0 { 1.0 } else { self.power(n - 1) + Self::power(self, n - 1) }
    }
}

fn main() {}
