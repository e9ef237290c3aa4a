#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Leaves a block.
#[function]
pub fn labels(x: f64) -> f64 {
    let inner = 'block: {
        break 'block 1.0;
    };
    x + inner
}

fn main() {}
