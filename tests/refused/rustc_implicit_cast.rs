#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Mixes types.
#[function]
pub fn mixed(n: u32, x: f64, y: f32) -> f64 {
    let scaled = x * n;
    let half: f64 = y;
    let count: usize = n;
    scaled + half
}

fn main() {}
