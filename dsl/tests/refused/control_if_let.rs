#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Takes an option apart.
#[function]
pub fn if_let(reading: Option<f64>) -> f64 {
    if let Some(value) = reading {
        return value;
    }
    let Some(value) = reading else {
        return 0.0;
    };
    match reading {
        Some(value) => value,
        None => 0.0,
    }
}

fn main() {}
