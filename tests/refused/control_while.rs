#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Until it is small.
#[function]
pub fn halved(x: f64, most: usize) -> f64 {
    let mut rest = x;
    #[bound(most)]
    while rest > 0.5 {
        rest /= 2.0;
    }
    #[bound(8)]
    for _ in 0..8 {
        rest /= 2.0;
    }
    rest
}

fn main() {}
