#![no_std]
extern crate std;

use bessemer::prelude::*;

/// Does with options what has no place in the C.
#[function]
pub fn options(mut value: Option<f64>, other: Option<f64>) -> Option<f64> {
    if let Some(x) = value.as_mut() {
        *x += 1.0;
    }
    value.get_or_insert_with(|| 2.0);
    let scaled = value.map(move |x| x * 2.0);
    let early = scaled.and_then(|x| {
        if x > 0.0 {
            return None;
        }
        Some(x)
    });
    early.xor(other)
}

fn main() {}
