#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Counts in a global.
#[function]
pub fn counted(x: f64) -> f64 {
    static mut CALLS: u32 = 0;
    if x > 0.0 {
        static TABLE: [f64; 2] = [1.0, 2.0];
        return TABLE[0];
    }
    unsafe {
        CALLS += 1;
    }
    x
}

/// Two fields at once.
#[function]
pub fn swapped(pair: &mut Pair) {
    Pair { low: pair.high, high: pair.low } = *pair;
}

/// A pair.
#[data]
#[derive(Clone, Copy)]
pub struct Pair {
    low: f64,
    high: f64,
}

fn main() {}
