#![no_std]
extern crate std;

use bessemer::prelude::*;

/// For ever.
#[function]
pub fn halved(x: f64) -> f64 {
    let mut rest = x;
    loop {
        rest /= 2.0;
        if rest < 1.0 {
            return rest;
        }
    }
}

fn main() {}
