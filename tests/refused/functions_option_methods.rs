#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Copies a variable at each pass.
#[function]
pub fn options(value: Option<f64>) -> f64 {
    let mut gain = 2.0;
    #[bound(9)]
    while value.is_some_and(move |x| x > gain) {
        gain += 1.0;
    }
    gain
}

fn main() {}
