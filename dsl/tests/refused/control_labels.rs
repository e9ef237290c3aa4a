#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Leaves two loops at once.
#[function]
pub fn labels(x: f64) -> f64 {
    let mut sum = x;
    'outer: for i in 0..3 {
        for _ in 0..i {
            break 'outer;
        }
    }
    let inner = 'block: {
        break 'block 1.0;
    };
    sum += inner;
    sum
}

fn main() {}
