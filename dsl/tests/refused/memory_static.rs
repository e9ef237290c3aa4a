#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Counts in a global.
#[function]
pub fn counted(x: f64) -> f64 {
    static CALLS: u32 = 0;
    x + CALLS as f64
}

fn main() {}
