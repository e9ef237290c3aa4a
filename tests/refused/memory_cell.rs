#![no_std]
extern crate std;

use core::cell::Cell;

use bessemer::prelude::*;

/// Shares mutable state.
#[function]
pub fn cell(total: &Cell<f64>, x: f64) -> f64 {
    total.set(total.get() + x);
    total.get()
}

fn main() {}
