#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Prints and formats.
#[function]
pub fn formatting(x: f64) -> f64 {
    let label = "height";
    println!("{label} {x}");
    let text = format!("{x}");
    let unit = 'm';
    x
}

fn main() {}
