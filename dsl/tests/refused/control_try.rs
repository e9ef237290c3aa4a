#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Hands an error on.
#[function]
pub fn corrected(reading: Result<f64, u8>) -> Result<f64, u8> {
    Ok(reading? + 1.0)
}

fn main() {}
