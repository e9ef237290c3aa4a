#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Copies by name, and converts by trait.
#[function]
pub fn copied(v: &Vector3<f64>, n: u32) -> f64 {
    let w = v.clone();
    w.x + f64::from(n)
}

fn main() {}
