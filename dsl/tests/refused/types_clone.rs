#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Copies by name.
#[function]
pub fn copied(v: &Vector3<f64>) -> f64 {
    let w = v.clone();
    w.x
}

fn main() {}
